# SPDX-FileCopyrightText: 2026 The brachisto authors
# SPDX-License-Identifier: MIT
"""Bodies that start together."""

from brachisto import _core
from brachisto._errors import NotVerified
from brachisto._pages import write_page
from brachisto._result import Result, solve
from brachisto._scene import Scene


class Race:
    """Bodies that start together, in the order of their arrival."""

    def __init__(self, results, same_track=False):
        answers = [result._core for result in results.values()]
        self._core = _core.Race(list(results), answers, same_track)
        self._results = {name: results[name] for name in self._core.names}

    @property
    def results(self):
        """The Result of each body, by its name, the first to arrive first."""
        return dict(self._results)

    def table(self):
        """Columns of the order of arrival: a dict of lists, which pandas.DataFrame takes.

        `body`, `transit_time` [s], `behind` [ms], a text with the digits that the errors
        leave, and `feasible`.
        """
        results = self._results.values()
        return {
            "body": list(self._results),
            "transit_time": [result.transit_time for result in results],
            "behind": self._core.behind,
            "feasible": [result.feasible for result in results],
        }

    def write_page(self, path, *, force=False):
        """Writes the page of the race, as `brachisto race --out` does.

        Raises OSError if it cannot be written, or if it is there and `force` is not given.
        """
        write_page(path, force, self._core.page)

    def _repr_html_(self):
        """All tracks in a small drawing and the order of arrival, for notebooks."""
        return self._core.card()

    def __repr__(self):
        order = ", ".join(
            f"{name} {result.transit_time:.6f} s" for name, result in self._results.items()
        )
        return f"<Race: {order}>"


def race(racers, *, same_track=False):
    """Lets bodies start together, each on its own track: a Race.

    `racers` is a mapping from a name to a Scene, which is solved, or to a Result. Their
    tracks have to have the same ends A and B. With `same_track` all take the track of the
    first one, and only that may be a Result; limits and paths of the others do not count.

    Raises InputError for what cannot race together, NotVerified if a scene fails.
    """
    if not _core.FEWEST_RACERS <= len(racers) <= _core.MOST_RACERS:
        raise ValueError(
            f"{_core.FEWEST_RACERS} to {_core.MOST_RACERS} bodies can race, not {len(racers)}"
        )
    results = {}
    for name, racer in racers.items():
        if not isinstance(racer, (Scene, Result)):
            kind = type(racer).__name__
            raise TypeError(f"{name}: expected a Scene or a Result, read one of type {kind}")
        if same_track and results:
            if isinstance(racer, Result):
                raise TypeError(f"{name}: on the track of another one it has to be solved anew; "
                                "give its Scene")
            first = next(iter(results.values()))
            racer = Scene._of_problem(racer._problem.on_track_of(first._core))
        result = solve(racer) if isinstance(racer, Scene) else racer
        if not result.verified:
            raise NotVerified(f"{name}: {result._complaint()}", result)
        results[str(name)] = result
    return Race(results, same_track)

