#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/importance.h>
#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/variances.h>

namespace fairlight {
namespace {

/// The integral of z^2 over the hemisphere. With uniform directions a draw is 2 pi z^2, of variance 4 pi^2 (1/5 - 1/9);
/// with cosine-weighted ones pi z, of variance pi^2 (1/2 - 4/9): 45/288 of it.
template <template <class> class Directions>
Contender squared_cosine(const std::string& name, double largest) {
  const Importance estimator(Directions<double>{}, [](const Vec3<double>& w) { return w.z() * w.z(); });
  return {name, [=](PhiloxStream<double>& source) { return estimator.estimate(source); }, 0, largest * (1 + 1e-12)};
}

void add_cosine_against_uniform(std::vector<Claim>& claims) {
  claims.push_back(variance_claim("variance.cosine_against_uniform", {"CosineHemisphere", "UniformHemisphere"},
                                  "elementary; the paper, 3.1", 45.0 / 288, 10,
                                  squared_cosine<CosineHemisphere>("cosine-weighted sampling", std::numbers::pi),
                                  squared_cosine<UniformHemisphere>("uniform sampling", 2 * std::numbers::pi)));
}

}  // namespace

void add_second_order_claims(std::vector<Claim>& claims) { add_cosine_against_uniform(claims); }

}  // namespace fairlight
