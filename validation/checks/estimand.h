#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include <fairlight/estimators/latin_hypercube.h>
#include <fairlight/estimators/sobol.h>
#include <fairlight/estimators/stratified.h>
#include <fairlight/validation/checks/claim.h>
#include <fairlight/validation/checks/constants.h>
#include <fairlight/validation/checks/means.h>

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
struct Estimand {
  std::string name;
  std::vector<std::string> subjects;
  std::string statement;
  std::string source;
  double margin_factor;
  std::vector<Reference> references;  ///< one a channel, exact
  Draw draw;                          ///< draw(std::type_identity<Real>, source) gives a Real or an Rgb<Real>
};

template <class Draw>
Estimand(std::string, std::vector<std::string>, std::string, std::string, double, std::vector<Reference>, Draw)
    -> Estimand<Draw>;

/// The finest margin that a claim is held to, however fine the run's, where more is rounded than by the arithmetic: in floats, the places of
/// a scene that is far away. That floats alone are too coarse for a margin the test says, and refuses it.
template <class Real>
double finest_margin_of(const std::vector<Reference>& references) {
  return finest_margin(references) > 0 ? finest_margin(rounded_references<Real>(references)) : 0;
}

/// An experiment as an arithmetic draws it.
template <class Real, class Draw>
Draws draws_of(const Estimand<Draw>& e) {
  return draws_of<Real>(body_of<Real>(e.draw), e.references.size());
}

/// The row of the registry for the mean of an experiment.
template <class Real, class Draw>
Claim mean_row(const Estimand<Draw>& e, std::function<Finding(const Trial&)> check) {
  return {.name = e.name + real_suffix<Real>(),
          .kind = "mean",
          .subjects = e.subjects,
          .statement = e.statement,
          .source = e.source,
          .margin_factor = e.margin_factor,
          .check = std::move(check),
          .real = real_name<Real>(),
          .finest_margin = finest_margin_of<Real>(e.references)};
}

/// From independent numbers of its own arithmetic alone: in double where packets round more than they mostly do, and where
/// it is the numbers themselves that are tested, for which no others stand in.
template <class Real, class Draw>
Claim mean_claim_alone(const Estimand<Draw>& e) {
  return mean_row<Real>(e, [references = e.references, draws = draws_of<Real>(e)](const Trial& trial) {
    return check_mean(trial, references, draws);
  });
}

/// From independent numbers; in double with a packet control variate where that is faster, and in packets over points where
/// they would take very long.
template <class Real = double, class Draw>
Claim mean_claim(const Estimand<Draw>& e) {
  if constexpr (lanes<Real> == 1) {
    const PairedDraws draws =
        paired_draws<Packet>(body_of<double>(e.draw), body_of<Packet>(e.draw), e.references.size());
    return mean_row<Real>(e, [references = e.references, draws](const Trial& trial) {
      return check_mean_in_double(trial, references, draws);
    });
  } else {
    return mean_row<Real>(e, [references = e.references, draws = draws_of<Real>(e)](const Trial& trial) {
      return check_mean_in_packets(trial, references, draws);
    });
  }
}

/// A kind of point set, and how it is named in a claim.
template <template <class> class Set>
struct PointSetKind {
  std::string suffix, subject;
  std::string source = "PointSource";
};
inline PointSetKind<OwenSobol> sobol_points() { return {"sobol", "OwenSobol"}; }
inline PointSetKind<Stratified> stratified_points() { return {"stratified", "Stratified"}; }
inline PointSetKind<LatinHypercube> latin_points() { return {"latin", "LatinHypercube"}; }

/// The row for the mean of an experiment from the points of a set, in packets, by replicates. Its margin is twice that from
/// independent numbers, or as said: what a set can do wrong, it does grossly.
template <template <class> class Set, class Draw>
Claim replicates_claim(const Estimand<Draw>& e, const PointSetKind<Set>& points, double margin_factor = 2) {
  std::vector<std::string> subjects = e.subjects;
  subjects.insert(subjects.end(), {points.subject, points.source});
  return {.name = e.name + "." + points.suffix,
          .kind = "mean",
          .subjects = subjects,
          .statement = e.statement + ", over the points of a replicate",
          .source = e.source,
          .margin_factor = margin_factor * e.margin_factor,
          .check =
              [references = e.references, body = body_of<Packet>(e.draw)](const Trial& trial) {
                return check_replicates<Set<Packet>>(trial, references, body, points_for(references));
              },
          .real = real_name<Packet>()};
}

/// From independent numbers, in double and in packets.
template <class Draw>
void add_independent_mean(std::vector<Claim>& claims, const Estimand<Draw>& e) {
  claims.push_back(mean_claim<double>(e));
  claims.push_back(mean_claim<Packet>(e));
}

/// From independent numbers, in double and in packets; and from the points of every set.
template <class Draw>
void add_mean(std::vector<Claim>& claims, const Estimand<Draw>& e) {
  add_independent_mean(claims, e);
  claims.push_back(replicates_claim(e, sobol_points()));
  claims.push_back(replicates_claim(e, stratified_points()));
  claims.push_back(replicates_claim(e, latin_points()));
}

}  // namespace fairlight
