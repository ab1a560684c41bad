#include <fairlight/validation/checks/law_claims.h>
#include <fairlight/validation/checks/padded_sets.h>
#include <fairlight/validation/claims/point_sets.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_point_sets.h>

namespace fairlight {
namespace {

Fault one_replicate() {
  const PointSetKind<faults::OneReplicateSobol> wrong{"sobol", ""};
  return {"sobol-one-replicate", "streams", "the class of SORT #35", {replicates_uncorrelated_claim(wrong)}};
}

Fault one_scramble() {
  const PointSetKind<faults::OneScrambleSobol> wrong{"sobol", ""};
  return {"sobol-one-scramble",
          "streams",
          "the class of SORT #35",
          {point_law_claim(wrong), point_moments_claim<double>(wrong), three_points_claim(wrong)}};
}

Fault one_order() {
  const PointSetKind<faults::OneOrderStratified> wrong{"stratified", ""};
  return {
      "strata-one-order",
      "streams",
      "Cook 1986 (strata of different dimensions are paired at random)",
      {point_moments_claim<Packet>(wrong), replicates_claim(product_integral(), wrong), three_points_claim(wrong)}};
}

Fault no_jitter() {
  const PointSetKind<faults::MidpointLatinHypercube> wrong{"latin", ""};
  return {"strata-midpoints",
          "missing jitter",
          "McKay, Beckman, Conover 1979 (jitter makes the mean unbiased)",
          {three_points_claim(wrong)}};
}

Fault one_vertex() {
  const PointSetKind<faults::OneVertexSobolSet> wrong{"padded_sobol", ""};
  return {"padded-one-vertex",
          "streams",
          "the class of SORT #35",
          {point_moments_claim<double>(wrong), point_moments_claim<Packet>(wrong),
           vertices_claim<double, faults::OneVertexSobol>("padded_sobol", {}),
           vertices_claim<Packet, faults::OneVertexSobol>("padded_sobol", {})}};
}

Fault same_order() {
  const PointSetKind<faults::OneOrderSobolSet> wrong{"padded_sobol", ""};
  return {"padded-one-order",
          "correlated dimensions",
          "PBR 4ed, 8.6.5 (padded dimensions are shuffled)",
          {product_variance_claim(wrong, 1.0 / 6)}};
}

Fault coarse_numbers() {
  const LawEstimand stream{"stream.philox",
                           "",
                           "",
                           []<class Real>(std::type_identity<Real>) { return faults::CoarseNumbers<Real>{}; },
                           SquareDomain{0, 1},
                           5,
                           true};
  return {.name = "numbers-of-16-bits",
          .kind = "streams",
          .source = "none: a random number made from 16 bits",
          .claims = {law_moments_claim(stream)},
          .survives =
              "its numbers are too small by 2^-17 in the mean, a thousandth of the margin, and fill all cells of a "
              "law's test evenly. Fine structure is for unit tests of the bits"};
}

Fault one_block() {
  const auto wrong = blocks_integral<faults::OneBlock>();
  return {"numbers-of-one-block",
          "streams",
          "none: a block's counter that is not increased",
          {mean_claim_alone<double>(wrong), mean_claim_alone<Packet>(wrong)}};
}

}  // namespace

std::vector<Fault> random_faults() {
  return {one_replicate(), one_scramble(), one_order(),      no_jitter(),
          one_vertex(),    same_order(),   coarse_numbers(), one_block()};
}

}  // namespace fairlight
