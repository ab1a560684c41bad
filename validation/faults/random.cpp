#include <fairlight/validation/checks/law_claims.h>
#include <fairlight/validation/checks/padded_sets.h>
#include <fairlight/validation/claims/point_sets.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_point_sets.h>

namespace fairlight {
namespace {

Fault coarse_numbers() {
  const LawEstimand stream{"stream.philox",    "", "",  component<faults::CoarseNumbers>(),
                           SquareDomain{0, 1}, 5,  true};
  return {.name = "numbers-of-16-bits",
          .kind = "streams",
          .source = "none: a random number made from 16 bits",
          .claims = {law_moments_claim(stream)},
          .survives =
              "its numbers are too small by 2^-17 in the mean, a thousandth of the margin, and fill all cells of a "
              "law's test evenly. Fine structure is for unit tests of the bits"};
}

}  // namespace

std::vector<Fault> random_faults() {
  const PointSetKind<faults::OneScrambleSobol> one_scramble{"sobol", ""};
  const PointSetKind<faults::OneOrderStratified> one_order{"stratified", ""};
  const PointSetKind<faults::OneVertexSobolSet> one_vertex{"padded_sobol", ""};
  const auto one_block = blocks_integral<faults::OneBlock>();
  return {{"sobol-one-replicate",
           "streams",
           "the class of SORT #35",
           {replicates_uncorrelated_claim(PointSetKind<faults::OneReplicateSobol>{"sobol", ""})}},
          {"sobol-one-scramble",
           "streams",
           "the class of SORT #35",
           {point_law_claim(one_scramble), point_moments_claim<double>(one_scramble),
            three_points_claim(one_scramble)}},
          {"strata-one-order",
           "streams",
           "Cook 1986 (strata of different dimensions are paired at random)",
           {point_moments_claim<Packet>(one_order), replicates_claim(product_integral(), one_order),
            three_points_claim(one_order)}},
          {"strata-midpoints",
           "missing jitter",
           "McKay, Beckman, Conover 1979 (jitter makes the mean unbiased)",
           {three_points_claim(PointSetKind<faults::MidpointLatinHypercube>{"latin", ""})}},
          {"padded-one-vertex",
           "streams",
           "the class of SORT #35",
           {point_moments_claim<double>(one_vertex), point_moments_claim<Packet>(one_vertex),
            vertices_claim<double, faults::OneVertexSobol>("padded_sobol", {}),
            vertices_claim<Packet, faults::OneVertexSobol>("padded_sobol", {})}},
          {"padded-one-order",
           "correlated dimensions",
           "PBR 4ed, 8.6.5 (padded dimensions are shuffled)",
           {product_variance_claim(PointSetKind<faults::OneOrderSobolSet>{"padded_sobol", ""}, 1.0 / 6)}},
          coarse_numbers(),
          {"numbers-of-one-block",
           "streams",
           "none: a block's counter that is not increased",
           {mean_claim_alone<double>(one_block), mean_claim_alone<Packet>(one_block)}}};
}

}  // namespace fairlight
