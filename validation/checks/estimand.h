#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include <fairlight/estimators/latin_hypercube.h>
#include <fairlight/estimators/sobol.h>
#include <fairlight/estimators/stratified.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/claim.h>
#include <fairlight/validation/checks/constants.h>
#include <fairlight/validation/checks/means.h>

namespace fairlight {

/// The suffix of a claim's name for a Real: none for double.
template <class Real>
std::string real_suffix() {
  return lanes<Real> > 1 ? ".packet" : "";
}
template <class Real>
std::string real_name() {
  return name_of(lanes<Real> > 1 ? Arithmetic::packets : Arithmetic::doubles);
}

/// A component with these parameters in every arithmetic: it takes type_identity<Real> and makes a
/// Component<Real>.
template <template <class> class Component, class... Number>
auto component(Number... parameters) {
  return [=]<class Real>(std::type_identity<Real>) { return Component<Real>(rounded<Real>(parameters)...); };
}

/// The statement that an estimator has a known mean, without its draws.
struct MeanStatement {
  std::string name;
  std::vector<std::string> subjects;
  std::string statement;
  std::string source;
  double margin_factor;
  std::vector<Reference> references;  ///< one for each channel, exact
};

/// An estimator with a known mean, written once and tested in every arithmetic and from every
/// source of numbers.
template <class Draw>
struct Estimand : MeanStatement {
  Draw draw;  ///< draw(std::type_identity<Real>, source) gives a Real or an Rgb<Real>
};

template <class Draw>
[[gnu::cold]] auto estimand(std::string name, std::vector<std::string> subjects, std::string statement,
                            std::string source, std::vector<Reference> references, Draw draw,
                            double margin_factor = 1) {
  return Estimand<Draw>{{std::move(name), std::move(subjects), std::move(statement), std::move(source),
                         margin_factor, std::move(references)},
                        std::move(draw)};
}

/// The references of the channels of a colour: reference(0), reference(1), reference(2).
std::vector<Reference> for_channels(const auto& reference) { return {reference(0), reference(1), reference(2)}; }

/// The suffix of a claim's name and its field `real`, for the arithmetic of its draws.
std::string suffix_of(const Draws& draws);
std::string real_of(const Draws& draws);

/// The rows of means, from draws whose type does not depend on the estimator.
Claim mean_row_alone(const MeanStatement& e, Draws draws);
Claim mean_row_in_double(const MeanStatement& e, PairedDraws draws);
Claim mean_row_in_packets(const MeanStatement& e, Draws draws);

/// The draws of an estimand in one arithmetic.
template <class Real, class Draw>
Draws draws_of(const Estimand<Draw>& e) {
  return draws_of<Real>(body_of<Real>(e.draw), e.references.size());
}

/// Tests the mean from independent numbers in one arithmetic alone, without a packet control
/// variate or point sets. It is for estimands whose packets round more than usual, and for tests of
/// the random numbers themselves, which no other numbers can replace.
template <class Real, class Draw>
Claim mean_claim_alone(const Estimand<Draw>& e) {
  return mean_row_alone(e, draws_of<Real>(e));
}

/// Tests the mean from independent numbers. In double it uses a packet control variate where that
/// is faster; in packets it uses Sobol' points where independent numbers would take very long.
template <class Real = double, class Draw>
Claim mean_claim(const Estimand<Draw>& e) {
  if constexpr (lanes<Real> == 1) {
    return mean_row_in_double(
        e, paired_draws<Packet>(body_of<double>(e.draw), body_of<Packet>(e.draw), e.references.size()));
  } else {
    return mean_row_in_packets(e, draws_of<Real>(e));
  }
}

/// The statement that every draw equals `value` to this many units in the last place.
struct ConstantStatement {
  std::string name;
  std::vector<std::string> subjects;
  std::string statement;  ///< without the tolerance
  std::string source;
  double value;
  int ulps;
};

/// An estimator without variance.
template <class Draw>
struct ConstantEstimand : ConstantStatement {
  Draw draw;  ///< as that of an Estimand
};

template <class Draw>
[[gnu::cold]] auto constant(std::string name, std::vector<std::string> subjects, std::string statement,
                            std::string source, double value, int ulps, Draw draw) {
  return ConstantEstimand<Draw>{
      {std::move(name), std::move(subjects), std::move(statement), std::move(source), value, ulps},
      std::move(draw)};
}

Claim constant_row(const ConstantStatement& e, Draws draws);

/// The row that tests this in one arithmetic.
template <class Real, class Draw>
Claim constant_claim(const ConstantEstimand<Draw>& e) {
  return constant_row(e, draws_of<Real>(body_of<Real>(e.draw), 1));
}

/// Adds this row in double and in packets.
template <class Draw>
void add_constant(std::vector<Claim>& claims, const ConstantEstimand<Draw>& e) {
  claims.push_back(constant_claim<double>(e));
  claims.push_back(constant_claim<Packet>(e));
}

/// A kind of point set, and its suffix in the names of claims.
template <template <class> class Set>
struct PointSetKind {
  std::string suffix, subject;
  std::string source = "PointSource";
};
inline PointSetKind<OwenSobol> sobol_points() { return {"sobol", "OwenSobol"}; }
inline PointSetKind<Stratified> stratified_points() { return {"stratified", "Stratified"}; }
inline PointSetKind<LatinHypercube> latin_points() { return {"latin", "LatinHypercube"}; }

/// Calls `f` with each of them.
void for_each_point_set(const auto& f) {
  f(sobol_points());
  f(stratified_points());
  f(latin_points());
}

/// The row for a mean over the points of a set, with this suffix and these further subjects.
Claim replicates_row(const MeanStatement& e, const std::string& suffix, const std::vector<std::string>& subjects,
                     double margin_factor, std::function<Finding(const Trial&)> check);

/// The row for the mean of an estimand over the points of a set, in packets, by replicates. Its
/// margin is `margin_factor` times that from independent numbers, as the errors of a point set are
/// large.
template <template <class> class Set>
Claim replicates_row(const MeanStatement& e, const std::shared_ptr<const Body<Packet>>& body,
                     const PointSetKind<Set>& points, double margin_factor) {
  return replicates_row(e, points.suffix, {points.subject, points.source}, margin_factor,
                        [references = e.references, body](const Trial& trial) {
                          return check_replicates<Set<Packet>>(trial, references, body, points_for(references));
                        });
}
template <template <class> class Set, class Draw>
Claim replicates_claim(const Estimand<Draw>& e, const PointSetKind<Set>& points, double margin_factor = 2) {
  return replicates_row(e, body_of<Packet>(e.draw), points, margin_factor);
}

/// Adds the rows from independent numbers, in double and in packets.
template <class Draw>
void add_independent_mean(std::vector<Claim>& claims, const Estimand<Draw>& e) {
  claims.push_back(mean_claim<double>(e));
  claims.push_back(mean_claim<Packet>(e));
}

/// The rows of several estimands from independent numbers, in double and in packets.
template <class... Draw>
std::vector<Claim> both(const Estimand<Draw>&... e) {
  std::vector<Claim> claims;
  (add_independent_mean(claims, e), ...);
  return claims;
}

/// Adds the rows from independent numbers, in double and in packets, and from every point set.
template <class Draw>
void add_mean(std::vector<Claim>& claims, const Estimand<Draw>& e) {
  add_independent_mean(claims, e);
  for_each_point_set([&](const auto& points) { claims.push_back(replicates_claim(e, points)); });
}

}  // namespace fairlight
