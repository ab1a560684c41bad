#pragma once

#include <array>

#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/uniform_sphere_area.h>
#include <fairlight/stats/domains.h>
#include <fairlight/stats/quadrature.h>
#include <fairlight/validation/checks/estimand.h>
#include <fairlight/validation/checks/laws.h>

namespace fairlight {

/// A sampler and its density, for the rows that state that the draws follow the density, which
/// integrates to one. `make(type_identity<Real>)` gives the sampler in an arithmetic. Packets are
/// held to the density in double, so rounding in float must not take a draw out of the support:
/// choose parameters that floats represent exactly.
template <class Make, class Domain>
struct LawEstimand {
  std::string name, subject, source;
  Make make;
  Domain domain;
  double law_margin = 5;    ///< of the chi-square row, in units of the run's: more where draws are expensive
  bool of_numbers = false;  ///< whether the draws are the random numbers themselves

  template <class Real>
  auto law() const {
    return make(std::type_identity<Real>{});
  }
};

template <class Make, class Domain>
LawEstimand(std::string, std::string, std::string, Make, Domain, double = 5, bool = false)
    -> LawEstimand<Make, Domain>;

/// Tests the law by chi-square. The margin is a relative L2 distance of laws: five times that of a
/// mean, or `law_margin` times.
template <class Make, class Domain>
Claim law_claim(const LawEstimand<Make, Domain>& e) {
  return {.name = e.name + ".law",
          .kind = "law",
          .subjects = {e.subject},
          .statement = "the draws follow the stated density, which integrates to one",
          .source = e.source,
          .margin_factor = e.law_margin,
          .check = [e](const Trial& trial) { return check_law(trial, e.template law<double>(), e.domain); }};
}

/// Tests the law by bounded moments, with an exact guarantee. The margin is ten times that of a
/// mean.
template <class Real = double, class Make, class Domain>
Claim law_moments_claim(const LawEstimand<Make, Domain>& e) {
  return {.name = e.name + ".moments" + real_suffix<Real>(),
          .kind = "law",
          .subjects = {e.subject},
          .statement =
              "the Rosenblatt transform of the draws has the cosine moments of the uniform law, up to the third",
          .source = e.source,
          .margin_factor = 10,
          .check =
              [e](const Trial& trial) {
                const auto drawn = e.template law<Real>();
                const auto law = e.template law<double>();
                return e.of_numbers ? check_law_moments(trial, drawn, law, e.domain)
                                    : check_law_moments_over_points(trial, drawn, law, e.domain);
              },
          .real = real_name<Real>()};
}

/// Tests that the density in packets equals that in double, at the draws of packets.
template <class Make, class Domain>
Claim density_claim(const LawEstimand<Make, Domain>& e) {
  return {.name = e.name + ".density.packet",
          .kind = "law",
          .subjects = {e.subject},
          .statement = "the density in packets is that in double: their ratio has the mean 1",
          .source = e.source,
          .margin_factor = 1,
          .check =
              [e](const Trial& trial) {
                return check_density(trial, e.template law<Packet>(), e.template law<double>());
              },
          .real = real_name<Packet>()};
}

/// The means of s, t and s t under a law, where (s, t) are the coordinates of its domain's unit
/// square. By quadrature.
template <class Law, class Domain>
std::vector<Reference> mean_coordinates(const Law& law, const Domain& domain) {
  const auto mean = [&](const auto& f) {
    return integrate_rectangle(
               [&](double s, double t) { return f(s, t) * law.pdf(domain.at(s, t)).value() * domain.size(); }, 0, 1,
               0, 1)
        .value;
  };
  const auto reference = [](double value) {
    return Reference{.mean = value, .lower = 0, .upper = 1, .scale = value, .rounding = 1e-6};  // of the quadrature
  };
  return {reference(mean([](double s, double) { return s; })), reference(mean([](double, double t) { return t; })),
          reference(mean([](double s, double t) { return s * t; }))};
}

/// The values s, t and s t of a packet of points, lane by lane.
template <class Domain, class Point>
Rgb<Packet> coordinates_and_product(const Domain& domain, const Point& points) {
  std::array<std::array<double, lanes<Packet>>, 3> numbers{};
  for (std::size_t i = 0; i < lanes<Packet>; ++i) {
    const Eigen::Vector2d place = domain.coordinates(detail::lane_of(points, i));
    numbers[0][i] = place.x();
    numbers[1][i] = place.y();
    numbers[2][i] = place.x() * place.y();
  }
  Rgb<Packet> packets;
  for (Eigen::Index c = 0; c < 3; ++c) load_lanes(numbers[static_cast<std::size_t>(c)].data(), packets[c]);
  return packets;
}

/// Tests the mean coordinates of the draws over the points of a set. A draw of the test is a whole
/// replicate.
template <template <class> class Set, class Make, class Domain>
Claim law_replicates_claim(const LawEstimand<Make, Domain>& e, const PointSetKind<Set>& points) {
  return {.name = e.name + ".coordinates." + points.suffix,
          .kind = "mean",
          .subjects = {e.subject, points.subject, points.source},
          .statement = "over the points of a replicate, the draws have the mean coordinates of the stated density",
          .source = e.source,
          .margin_factor = 2,
          .check =
              [e](const Trial& trial) {
                const auto law = e.template law<Packet>();
                const auto references = mean_coordinates(e.template law<double>(), e.domain);
                const auto draw = [law, domain = e.domain](std::type_identity<Packet>, auto& source) {
                  return coordinates_and_product(domain, law.sample(next_pair<Packet>(source)));
                };
                return check_replicates<Set<Packet>>(trial, references, body_of<Packet>(draw),
                                                     points_for(references));
              },
          .real = real_name<Packet>()};
}

/// Adds all rows of a law.
template <class Make, class Domain>
void add_law(std::vector<Claim>& claims, const LawEstimand<Make, Domain>& e) {
  claims.push_back(law_claim(e));
  claims.push_back(law_moments_claim<double>(e));
  claims.push_back(law_moments_claim<Packet>(e));
  claims.push_back(density_claim(e));
  for_each_point_set([&](const auto& points) { claims.push_back(law_replicates_claim(e, points)); });
}

/// Uniform points on a sphere of radius 2.5.
template <template <class> class Points>
auto sphere_area_law() {
  return LawEstimand{"sphere_light.area", "UniformSphereArea", "Archimedes", component<Points>(2.5),
                     SphereDomain{2.5}};
}

/// Cosine-weighted directions.
template <template <class> class Directions>
auto cosine_law() {
  return LawEstimand{"hemisphere.cosine", "CosineHemisphere", "PBR 4ed, A.5.3", component<Directions>(),
                     HemisphereDomain{}};
}

/// Pairs of random numbers, unchanged: uniform on the unit square.
template <class Real>
struct UniformSquare {
  using Scalar = Real;
  using Point = Vec2<Real>;
  using Measure = UnitCube;
  Point sample(const Vec2<Real>& u) const { return u; }
  Density<Measure, Real> pdf(const Point&) const { return Density<Measure, Real>(Real(1)); }
};

}  // namespace fairlight
