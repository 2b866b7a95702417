% SPDX-FileCopyrightText: 2026 The brachisto authors
% SPDX-License-Identifier: MIT

% The paper's discrete system, eqs. (13)-(19), solved by GNU Octave's fsolve from
% the cycloid; one line of JSON.
%
%   octave-cli --no-init-file paper_fsolve.m --n 100 --datum release
%
% Options (defaults in brackets): --n [100], --datum release|rest|printed,
% --slopes literal|smooth, --epsilon [1e-3], --updating on|off (off: a Jacobian in
% every iteration), --tol [1e-10] on steps and F, --seconds [600] of processor time,
% --L [3] --H [1] --r [1/3] --eta [2/3] --theta [0] --k [1/2].
%
% Quadrature: the time of a chord of length l is 2 l / (v + v') with the speeds at
% its ends. Lengths are in H, times in sqrt (H / 2g), so that T is tau.
1;

function o = options (args)
  o = struct ('n', 100, 'datum', 'release', 'slopes', 'literal', 'epsilon', 1e-3, ...
              'updating', 'on', 'tol', 1e-10, 'seconds', 600, ...
              'L', 3, 'H', 1, 'r', 1/3, 'eta', 2/3, 'theta', 0, 'k', 1/2);
  for i = 1:2:numel (args) - 1
    key = args{i}(3:end);
    if (! isfield (o, key)), error ('unknown option %s', args{i}); end
    if (ischar (o.(key))), o.(key) = args{i+1};
    else, o.(key) = eval ([args{i+1} ';']); end
  end
  o.L = o.L / o.H;
  o.r = o.r / o.H;
end

% Times of the paths (x, Z(:,i)), all at once.
function T = transit (x, Z, o)
  dz = diff (Z);
  dx = repmat (diff (x), 1, columns (Z));
  l = sqrt (dx.^2 + dz.^2);
  theta = o.theta + [zeros(1, columns (Z)); cumsum(l)] / o.r;
  E = Z + o.r * o.eta * (sin (theta) - sin (o.theta));
  if (strcmp (o.datum, 'release')), E -= Z(1,:); end
  if (! strcmp (o.datum, 'printed')), E(1,:) = 0; end
  % A has sin (theta - beta) of the chord on either side of a node.
  sine = sin (theta);
  cosine = cos (theta);
  c = dx ./ l;
  s = dz ./ l;
  full = 1 + o.eta^2 + o.k;
  left = full - 2 * o.eta * (sine(1:end-1,:) .* c - cosine(1:end-1,:) .* s);
  right = full - 2 * o.eta * (sine(2:end,:) .* c - cosine(2:end,:) .* s);
  v = sqrt (E(1:end-1,:) ./ left);
  w = sqrt (E(2:end,:) ./ right);
  T = sum (2 * l ./ (v + w), 1);
end

function [s, c] = slope (dx, dz, o)
  if (strcmp (o.slopes, 'literal'))
    t = dz / dx;
    s = t / sqrt (1 + t^2);
    c = 1 / sqrt (1 + t^2);
  else
    s = dz / sqrt (dx^2 + dz^2);
    c = dx / sqrt (dx^2 + dz^2);
  end
end

function F = equations (u, o)
  global calls deadline
  calls++;
  if (cputime () > deadline), error ('time limit'); end
  n = o.n;
  x = u(1:n);
  z = u(n+1:2*n);
  moved = o.epsilon * [zeros(1, n-2); eye(n-2); zeros(1, n-2)];
  [s_A, c_A] = slope (x(2) - x(1), z(2) - z(1), o);
  [s_B, c_B] = slope (x(n) - x(n-1), z(n) - z(n-1), o);
  dT = (transit (x, z + moved, o) - transit (x, z - moved, o)) / (2 * o.epsilon);
  F = [x(1) - o.r * s_A;
       sqrt(diff (x).^2 + diff (z).^2) - u(end) / (n - 1);
       z(1) + o.r * c_A;
       dT(:);
       z(n) + o.r * c_B - 1;
       x(n) - o.r * s_B - o.L];
end

% The centre of the uniform cylinder: x = r + a (p - sin p), z = a (1 - cos p),
% whose slope at the end is that of the track at B.
function u = cycloid (o)
  span = @(p) p - sin (p);
  reach = @(p) (1 - o.r * sin (p / 2)) * span (p) ./ (1 - cos (p)) ...
               - (o.L - o.r + o.r * cos (p / 2));
  grid = linspace (0.05, 2 * pi - 0.05, 400);
  value = arrayfun (reach, grid);
  i = find (value(1:end-1) .* value(2:end) <= 0, 1);
  if (isempty (i)), error ('no cycloid'); end
  p = fzero (reach, grid([i, i+1]));
  a = (1 - o.r * sin (p / 2)) / (1 - cos (p));
  S = 4 * a * (1 - cos (p / 2));
  q = 2 * acos (1 - linspace (0, S, o.n)' / (4 * a));
  u = [o.r + a * (q - sin (q)); a * (1 - cos (q)); S];
end

function kb = peak_memory ()
  kb = NaN;
  text = fileread ('/proc/self/status');
  found = regexp (text, 'VmHWM:\s+(\d+) kB', 'tokens');
  if (! isempty (found)), kb = str2double (found{1}{1}); end
end

global calls deadline
o = options (argv ());
settings = optimset ('TolX', o.tol, 'TolFun', o.tol, 'MaxIter', 400, ...
                     'MaxFunEvals', Inf, 'Updating', o.updating);
calls = 0;
result = struct ('program', 'octave', 'version', version (), 'n', o.n, 'datum', o.datum, ...
                 'slopes', o.slopes, 'epsilon', o.epsilon, 'updating', o.updating, 'tol', o.tol);
begin = cputime ();
try
  u = cycloid (o);
  begin = cputime ();
  deadline = begin + o.seconds;
  [u, F, info, out] = fsolve (@(w) equations (w, o), u, settings);
  result.seconds_cpu = cputime () - begin;
  result.info = info;
  result.iterations = out.iterations;
  result.residual = norm (F);
  result.real = isreal (u) && isreal (F);
  result.solved = result.real && result.residual <= 1e-6;
  result.tau = NaN;
  if (result.solved), result.tau = transit (u(1:o.n), u(o.n+1:2*o.n), o); end
  result.S = real (u(end)) * o.H;
  result.message = '';
catch problem
  result.seconds_cpu = cputime () - begin;
  result.solved = false;
  result.tau = NaN;
  result.message = problem.message;
end
result.calls = calls;
result.peak_kb = peak_memory ();
printf ('%s\n', jsonencode (result));
