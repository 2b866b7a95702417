// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/scene_json.hpp"

#include <array>
#include <cstdio>
#include <optional>
#include <utility>

#include "model/limit_table.hpp"
#include "proof/equations.hpp"

namespace brachisto::proof {

namespace {

constexpr std::array<std::pair<Contact, const char*>, 4> kContacts{
    {{Contact::Smooth, "smooth"},
     {Contact::Centre, "centre"},
     {Contact::Optimal, "optimal"},
     {Contact::EndSlope, "end_slope"}}};

Json limits_json(const PathLimits& limits) {
  Json out = Json::object();
  for (const LimitEntry& limit : limit_table()) {
    if (const auto& bound = limit.bound(limits)) {
      out[limit.name()] = hex(*bound);
    }
  }
  if (limits.curvature.of == CurvatureLimit::Of::Centre) {
    out["curvature.of"] = "centre";
  }
  for (const Disc& disc : limits.discs) {
    out["discs"].push_back({{"x", hex(disc.centre.x)},
                            {"z", hex(disc.centre.z)},
                            {"radius", hex(disc.radius)}});
  }
  for (const HalfPlane& plane : limits.half_planes) {
    out["half_planes"].push_back({{"x", hex(plane.point.x)},
                                  {"z", hex(plane.point.z)},
                                  {"normal", hex(plane.normal)}});
  }
  return out;
}

PathLimits limits_from(const Json& said) {
  PathLimits out;
  for (const LimitEntry& limit : limit_table()) {
    const std::string key(limit.name());
    if (said.contains(key)) limit.bound_in(out) = number(said, key);
  }
  if (said.contains("curvature.of")) {
    out.curvature.of = CurvatureLimit::Of::Centre;
  }
  for (const Json& each : said.value("discs", Json::array())) {
    out.discs.push_back(
        {{number(each, "x"), number(each, "z")}, number(each, "radius")});
  }
  for (const Json& each : said.value("half_planes", Json::array())) {
    out.half_planes.push_back(
        {{number(each, "x"), number(each, "z")}, number(each, "normal")});
  }
  return out;
}

Json world_json(World world) {
  Json out = Json::object();
  if (const FieldKind* kind = field_kind(world)) out["field"] = kind->key;
  for (const WorldParameter& each : kWorldParameters) {
    if (const double* value = each.find_in(world)) out[each.key] = hex(*value);
  }
  return out;
}

World world_from(const Json& said) {
  World out;
  for (const FieldKind& kind : kFieldKinds) {
    if (said.value("field", "") == kind.key) kind.put_into(out);
  }
  for (const WorldParameter& each : kWorldParameters) {
    if (double* value = each.find_in(out)) *value = number(said, each.key);
  }
  return out;
}

}  // namespace

std::string hex(double number) {
  // Not by fmt, whose versions write 0 in different ways.
  std::array<char, 32> out{};
  const int size = std::snprintf(out.data(), out.size(), "%a", number);
  return {out.data(), static_cast<std::size_t>(size)};
}

double number(const Json& object, std::string_view key) {
  const std::string text = object.at(key).get<std::string>();
  std::size_t read = 0;
  const double out = std::stod(text, &read);
  if (read != text.size()) throw Refused("the scene has no such number");
  return out;
}

Real ball(const Json& text) {
  Real out;
  if (!Real::read(text.get<std::string>(), out) || !out.finite()) {
    throw Refused("a ball cannot be read");
  }
  return out;
}

Json scene_json(const Scene& scene) {
  Json out = {{"shape", scene.body.rolls() ? "cylinder" : "bead"},
              {"radius", hex(scene.body.radius)},
              {"eta_m", hex(scene.body.eta_m)},
              {"theta_m", hex(scene.body.theta_m)},
              {"k", hex(scene.body.k)},
              {"L", hex(scene.L)},
              {"H", hex(scene.H)}};
  for (const auto& [contact, name] : kContacts) {
    if (scene.contact == contact) out["contact"] = name;
  }
  if (is_plain(scene)) return out;
  out["gravity"] = hex(scene.gravity);
  out["world"] = world_json(scene.world);
  out["limits"] = limits_json(scene.limits);
  if (scene.end_slope) out["end_slope"] = hex(*scene.end_slope);
  return out;
}

Scene scene_from(const Json& said) {
  Scene scene;
  if (said.at("shape") == "bead") {
    scene.body = Body::bead();
  } else {
    scene.body = Body::cylinder(number(said, "radius"), number(said, "eta_m"),
                                number(said, "theta_m"), number(said, "k"));
  }
  scene.L = number(said, "L");
  scene.H = number(said, "H");
  for (const auto& [contact, name] : kContacts) {
    if (said.at("contact") == name) scene.contact = contact;
  }
  if (said.contains("world")) {
    scene.gravity = number(said, "gravity");
    scene.world = world_from(said.at("world"));
    scene.limits = limits_from(said.at("limits"));
    if (said.contains("end_slope")) scene.end_slope = number(said, "end_slope");
  }
  if (!validate(scene).empty() || scene_json(scene) != said) {
    throw Refused("its scene is not valid");
  }
  return scene;
}

}  // namespace brachisto::proof
