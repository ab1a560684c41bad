#include <fairlight/validation/checks/law_claims.h>
#include <fairlight/validation/checks/padded_sets.h>
#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/point_sets.h>
#include <fairlight/validation/claims/streams.h>

namespace fairlight {

namespace {

template <template <class> class Set>
void add_point_set(std::vector<Claim>& claims, const PointSetKind<Set>& kind) {
  claims.push_back(point_law_claim(kind));
  claims.push_back(point_moments_claim<double>(kind));
  claims.push_back(point_moments_claim<Packet>(kind));
  claims.push_back(replicates_uncorrelated_claim(kind));
}

template <template <class> class Set, class Numbers>
void add_padded_set(std::vector<Claim>& claims, const PointSetKind<Set>& kind, std::uint32_t width, double ratio) {
  add_point_set(claims, kind);
  claims.push_back(vertices_claim<double, Numbers>(kind.suffix, {kind.subject}));
  claims.push_back(vertices_claim<Packet, Numbers>(kind.suffix, {kind.subject}));
  claims.push_back(stratified_variance_claim(kind, 16, width));
  claims.push_back(product_variance_claim(kind, ratio));
}

}  // namespace

void add_random_claims(std::vector<Claim>& claims) {
  add_law(claims, LawEstimand{"stream.philox", "PhiloxStream", "Salmon et al. 2011", component<UniformSquare>(),
                              SquareDomain{0, 1}, 5, true});
  claims.push_back(streams_uncorrelated_claim());
  claims.push_back(mean_claim_alone<double>(product_integral()));
  claims.push_back(mean_claim_alone<Packet>(product_integral()));
  claims.push_back(mean_claim_alone<double>(blocks_integral()));
  claims.push_back(mean_claim_alone<Packet>(blocks_integral()));
  for_each_point_set([&](const auto& kind) {
    claims.push_back(replicates_claim(product_integral(), kind, 1));
    claims.push_back(three_points_claim(kind));
    add_point_set(claims, kind);
  });
  claims.push_back(stratified_variance_claim(sobol_points(), 16, 16));
  claims.push_back(stratified_variance_claim(stratified_points(), 16, 4));
  claims.push_back(stratified_variance_claim(latin_points(), 16, 16));
  claims.push_back(vertices_claim<double, IndependentNumbers>("independent", {"IndependentNumbers"}, 1));
  claims.push_back(vertices_claim<Packet, IndependentNumbers>("independent", {"IndependentNumbers"}, 1));
  add_padded_set<PaddedSobolSet, PaddedSobol>(claims, padded_sobol_points(), 16, 1.0 / 6);
  add_padded_set<PaddedStrataSet, PaddedStrata>(claims, padded_strata_points(), 4, 2.0 / 9);
}

}  // namespace fairlight
