#include <fairlight/validation/analytic/integrals.h>
#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/laws.h>

namespace fairlight {

void add_direction_claims(std::vector<Claim>& claims) {
  constexpr double tau = 2 * std::numbers::pi;
  add_law(claims, LawExperiment{"hemisphere.uniform", "UniformHemisphere", "PBR 4ed, A.5.2",
                                []<class Real>(std::type_identity<Real>) { return UniformHemisphere<Real>{}; },
                                HemisphereDomain{}});
  add_law(claims, cosine_law<CosineHemisphere>());
  add_mean(claims,
           hemisphere_integral<UniformHemisphere>("importance.uniform.cosine", "UniformHemisphere", 1, tau));
  add_mean(claims, hemisphere_integral<CosineHemisphere>("importance.cosine.cosine_squared", "CosineHemisphere", 2,
                                                         tau / 2));
}

}  // namespace fairlight
