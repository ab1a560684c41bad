#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include <fairlight/validation/checks.h>

namespace fairlight {

/// How a Real is named in a claim: nothing for double, the reference.
template <class Real>
std::string real_suffix() {
  return lanes<Real> > 1 ? ".packet" : "";
}
template <class Real>
std::string real_name() {
  return lanes<Real> > 1 ? "packet" : "double";
}

/// An estimator whose mean is known, written once and run in every arithmetic and from every source of numbers.
template <class Draw>
struct Experiment {
  std::string name;
  std::vector<std::string> subjects;
  std::string statement;
  std::string source;
  double margin_factor;
  std::vector<Reference> references;  ///< one a channel, exact
  Draw draw;                          ///< draw(std::type_identity<Real>, source) gives a Real or an Rgb<Real>
};

template <class Draw>
Experiment(std::string, std::vector<std::string>, std::string, std::string, double, std::vector<Reference>, Draw)
    -> Experiment<Draw>;

/// The row of the registry for the mean of an experiment, from independent numbers.
template <class Real = double, class Draw>
Claim mean_claim(const Experiment<Draw>& e) {
  return {.name = e.name + real_suffix<Real>(),
          .kind = "mean",
          .subjects = e.subjects,
          .statement = e.statement,
          .source = e.source,
          .margin_factor = e.margin_factor,
          .check =
              [e](const Trial& trial) {
                return check_mean<Real>(trial, e.references,
                                        [&](auto& source) { return e.draw(std::type_identity<Real>{}, source); });
              },
          .real = real_name<Real>()};
}

/// In double and in packets.
template <class Draw>
void add_mean(std::vector<Claim>& claims, const Experiment<Draw>& e) {
  claims.push_back(mean_claim<double>(e));
  claims.push_back(mean_claim<Packet>(e));
}

}  // namespace fairlight
