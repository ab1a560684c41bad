#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/importance.h>
#include <fairlight/validation/analytic/furnace.h>
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

/// A furnace of radiance 1 and reflectance 1/2 shows 2. A path ended by roulette sees N vertices, geometric with the mean 2 and the
/// variance 2, so that the mean of 64 is off by the square 2/64 = 1/32 in the mean. Paths that all end at two vertices,
/// the same length, show 1.5, and are off by the square 1/4 however many there are: eight times as much.
/// Bound: the mean M of 64 such N exceeds 4 with probability at most exp(-64 I(4)) = 3e-15, I(4) = 3 ln(3/2) - ln 2 (Chernoff),
/// so 1e-10 is more than E[((M - 2)^2 - 4)+].
Claim roulette_against_fixed_depth() {
  return {.name = "variance.roulette_against_fixed_depth",
          .kind = "variance",
          .subjects = {"RouletteByReflectance", "NoRoulette", "PathTracer"},
          .statement =
              "in a furnace, 64 paths ended by roulette are off by an eighth of the square by which paths of a "
              "fixed depth "
              "and the same length are",
          .source = "geometric series; the paper, 3.2.1",
          .margin_factor = 30,
          .check = [](const Trial& trial) {
            Furnace furnace;
            Scene scene;
            scene.add_sphere({3, -2, 5}, 7, Rgb<double>::Constant(0.5), Rgb<double>::Ones());
            const PathTracer<CosineHemisphere, NoDirectLight, RouletteByReflectance<>> tracer;
            const PathTracer<CosineHemisphere, NoDirectLight, NoRoulette> cut(1);
            PhiloxStream<double> any_numbers(StreamKey(trial.seed, trial.claim), 1, 0);
            const double dark = 2 - cut.radiance<double>(scene, furnace.ray, any_numbers)[0];
            const Reference reference{.mean = dark * dark / 8, .lower = 0, .upper = 4, .tail_slack = 1e-10};
            return check_mean(trial, {reference}, [&](auto& source) {
              double sum = 0;
              for (int i = 0; i < 64; ++i) sum += tracer.radiance<double>(scene, furnace.ray, source)[0];
              return (sum / 64 - 2) * (sum / 64 - 2);
            });
          }};
}

}  // namespace

void add_second_order_claims(std::vector<Claim>& claims) {
  add_cosine_against_uniform(claims);
  claims.push_back(roulette_against_fixed_depth());
}

}  // namespace fairlight
