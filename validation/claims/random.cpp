#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/laws.h>

namespace fairlight {

void add_random_claims(std::vector<Claim>& claims) {
  add_law(claims, LawExperiment{"stream.philox", "PhiloxStream", "Salmon et al. 2011",
                                []<class Real>(std::type_identity<Real>) { return StreamPairs<Real>{}; },
                                SquareDomain{0, 1}});
}

}  // namespace fairlight
