#pragma once

#include <fairlight/stats/domains.h>
#include <fairlight/validation/checks.h>

namespace fairlight {

/// The row that says: this sampler's draws follow its density, which integrates to one.
/// The margin is a relative L2 distance of laws, five times that of a mean.
template <Sampler Law, class Domain>
Claim law_claim(const std::string& name, const std::string& subject, const std::string& source, const Law& law,
                const Domain& domain) {
  return {name + ".law",
          "law",
          {subject},
          "the draws follow the stated density, which integrates to one",
          source,
          5,
          [=](const Trial& trial) { return check_law(trial, law, domain); }};
}

/// The row that says the same exactly, by bounded moments; its margin is ten times that of a mean.
template <Sampler Law, class Domain>
Claim law_moments_claim(const std::string& name, const std::string& subject, const std::string& source,
                        const Law& law, const Domain& domain) {
  return {name + ".moments",
          "law",
          {subject},
          "the Rosenblatt transform of the draws has the cosine moments of the uniform law, up to the third",
          source,
          10,
          [=](const Trial& trial) { return check_law_moments(trial, law, domain); }};
}

/// Both.
template <Sampler Law, class Domain>
void add_law(std::vector<Claim>& claims, const std::string& name, const std::string& subject,
             const std::string& source, const Law& law, const Domain& domain) {
  claims.push_back(law_claim(name, subject, source, law, domain));
  claims.push_back(law_moments_claim(name, subject, source, law, domain));
}

/// Pairs of numbers of a stream, as they come: uniform on the unit square.
struct StreamPairs {
  using Scalar = double;
  using Point = Vec2<double>;
  using Measure = UnitCube;
  Point sample(const Vec2<double>& u) const { return u; }
  Density<Measure, double> pdf(const Point&) const { return Density<Measure, double>(1); }
};

}  // namespace fairlight
