#include <fairlight/validation/analytic/point_sets.h>
#include <fairlight/validation/analytic/streams.h>
#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/laws.h>

namespace fairlight {

namespace {

template <template <class> class Set>
void add_point_set(std::vector<Claim>& claims, const PointSetKind<Set>& kind) {
  claims.push_back(point_law_claim(kind));
  claims.push_back(point_moments_claim<double>(kind));
  claims.push_back(point_moments_claim<Packet>(kind));
  claims.push_back(replicates_uncorrelated_claim(kind));
  claims.push_back(three_points_claim(kind));
}

}  // namespace

void add_random_claims(std::vector<Claim>& claims) {
  add_law(claims, LawExperiment{"stream.philox", "PhiloxStream", "Salmon et al. 2011",
                                []<class Real>(std::type_identity<Real>) { return UniformSquare<Real>{}; },
                                SquareDomain{0, 1}});
  claims.push_back(streams_uncorrelated_claim());
  claims.push_back(mean_claim<double>(product_integral()));
  claims.push_back(mean_claim<Packet>(product_integral()));
  claims.push_back(replicates_claim(product_integral(), sobol_points, 1));
  claims.push_back(replicates_claim(product_integral(), stratified_points, 1));
  claims.push_back(replicates_claim(product_integral(), latin_points, 1));
  add_point_set(claims, sobol_points);
  add_point_set(claims, stratified_points);
  add_point_set(claims, latin_points);
  claims.push_back(stratified_variance_claim(sobol_points, 16, 16));
  claims.push_back(stratified_variance_claim(stratified_points, 16, 4));
  claims.push_back(stratified_variance_claim(latin_points, 16, 16));
}

}  // namespace fairlight
