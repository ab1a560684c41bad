#include <fairlight/validation/analytic/integrals.h>
#include <fairlight/validation/claims/claims.h>

namespace fairlight {

void add_combinator_claims(std::vector<Claim>& claims) {
  add_mean(claims, roulette_integral<RussianRoulette>("roulette.integral", 0.3));
  add_mean(claims, two_dice<AllOf>("pick.all.dice", {"AllOf"}));
  add_mean(claims, two_dice<OneOf>("pick.one.dice", {"OneOf", "UniformChoice"}));
}

}  // namespace fairlight
