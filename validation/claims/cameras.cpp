#include <fairlight/estimators/filter.h>
#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/laws.h>

namespace fairlight {

void add_camera_claims(std::vector<Claim>& claims) {
  add_law(claims, LawExperiment{"filter.tent", "TentFilter", "Ernst, Stamminger, Greiner 2006",
                                []<class Real>(std::type_identity<Real>) { return TentFilter<Real>{}; },
                                SquareDomain{-1, 1}});
}

}  // namespace fairlight
