#include <fairlight/validation/analytic/integrals.h>
#include <fairlight/validation/claims/claims.h>

namespace fairlight {

void add_material_claims(std::vector<Claim>& claims) {
  add_mean(claims, lambertian_albedo<UniformHemisphere>("lambertian.uniform.albedo", "UniformHemisphere"));
  claims.push_back(lambertian_constant<double>());
  claims.push_back(lambertian_constant<Packet>());
}

}  // namespace fairlight
