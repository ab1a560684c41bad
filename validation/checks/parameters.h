#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <fairlight/validation/checks/estimand.h>

/// Claims whose parameters are drawn anew in every run, over the domain that a component states.
namespace fairlight {

/// The domain of a parameter as the component's page states it.
struct ParameterDomain {
  std::string component, parameter, unit;
  double low, high;
  std::string gap;  ///< why no claim reaches an end of the domain; empty if claims reach both
};

/// The domains of all parameters, in checks/domains.cpp.
const std::vector<ParameterDomain>& parameter_domains();

/// Throws std::logic_error, with the claim's name, for a range of an unknown parameter or outside
/// its domain: a fault of the claim.
void check_ranges(const std::string& claim, const std::vector<ParameterRange>& ranges);

/// A value from each range: the middle of each, or drawn from the seed and the claim's name.
std::vector<double> middles(const std::vector<ParameterRange>& ranges);
std::vector<double> drawn(const std::vector<ParameterRange>& ranges, const Trial& trial);

/// A parameter rounded to float, which packets hold exactly.
inline double in_floats_exactly(double value) { return static_cast<double>(static_cast<float>(value)); }

/// The values of a claim's parameters, one after another.
class DrawnValues {
 public:
  explicit DrawnValues(const std::vector<double>& values) : values_(&values) {}
  double next() { return values_->at(used_++); }
  Eigen::Vector3d next_vector() {
    const double x = next(), y = next();
    return {x, y, next()};
  }

 private:
  const std::vector<double>* values_;
  std::size_t used_ = 0;
};

/// Adds the values to the note of a finding that is not certified.
Finding with_parameters(Finding finding, const std::vector<ParameterRange>& ranges,
                        const std::vector<double>& values);

/// The row for the mean of `make(values)`, an Estimand, at values drawn from the ranges. Only its
/// references and its draws may depend on the values. Throws what check_ranges throws. `row` is the
/// Estimand that names the row: make(middles(ranges)), or one without references where these take
/// long.
template <class Real, class Make, class Row>
Claim mean_claim_over(const std::vector<ParameterRange>& ranges, const Make& make, const Row& row) {
  Claim claim = mean_claim<Real>(row);
  check_ranges(claim.name, ranges);
  claim.covers = ranges;
  claim.check = [ranges, make](const Trial& trial) {
    const std::vector<double> values = drawn(ranges, trial);
    return with_parameters(mean_claim<Real>(make(values)).check(trial), ranges, values);
  };
  return claim;
}

template <class Real, class Make>
Claim mean_claim_over(const std::vector<ParameterRange>& ranges, const Make& make) {
  return mean_claim_over<Real>(ranges, make, make(middles(ranges)));
}

/// Adds these rows in double and in packets.
template <class Make>
void add_mean_over(std::vector<Claim>& claims, const std::vector<ParameterRange>& ranges, const Make& make) {
  claims.push_back(mean_claim_over<double>(ranges, make));
  claims.push_back(mean_claim_over<Packet>(ranges, make));
}

}  // namespace fairlight
