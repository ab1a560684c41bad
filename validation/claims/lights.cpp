#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/laws.h>

namespace fairlight {

void add_light_claims(std::vector<Claim>& claims) { add_law(claims, sphere_area_law<UniformSphereArea>()); }

}  // namespace fairlight
