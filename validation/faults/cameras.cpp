#include <fairlight/validation/analytic/camera.h>
#include <fairlight/validation/analytic/lens.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_cameras.h>

namespace fairlight {

namespace {

template <template <class> class Aperture>
std::vector<Claim> claims_of_an_aperture() {
  const auto law = circular_aperture_law<Aperture>();
  const auto behind = circle_of_confusion<Aperture, ThinLens>(3.5);
  return {law_claim(law), law_moments_claim(law), law_moments_claim<Packet>(law), mean_claim(behind),
          mean_claim<Packet>(behind)};
}

Fault crowded_aperture() {
  return {"aperture-without-root", "Montelight", "the class of Smerity/montelight-cpp",
          claims_of_an_aperture<faults::CrowdedAperture>()};
}

Fault square_aperture() {
  return {"aperture-square", "lens", "the class of pbrt-v3 #162", claims_of_an_aperture<faults::SquareAperture>()};
}

Fault unnormalised_gaussian() {
  const auto law = gaussian_law<faults::UnnormalisedGaussian>();
  return {"gaussian-not-renormalised", "support", "the class of pbrt-v3 #319", claims_of_draws(law)};
}

Fault spherical_focus() {
  const auto before = circle_of_confusion<CircularAperture, faults::SphericalFocus>(0.75);
  return {"focus-along-the-ray",
          "measure",
          "a distance along the ray for one along the axis: the class of Baikal #82",
          {focus_claim<double, faults::SphericalFocus>(), focus_claim<Packet, faults::SphericalFocus>(),
           mean_claim(before), mean_claim<Packet>(before)}};
}

Fault rays_about_corners() {
  using Wrong = faults::RaysAboutCorners;
  return {"pixel-corner",
          "filter",
          "half a pixel lost: the class of Heckbert 1990, \"What are the coordinates of a pixel?\"",
          {mean_claim(pinhole_crossings<Wrong>()), mean_claim<Packet>(pinhole_crossings<Wrong>()),
           mean_claim(lens_crossings<Wrong>()), mean_claim<Packet>(lens_crossings<Wrong>())}};
}

Fault rays_that_share_numbers() {
  using Wrong = faults::RaysThatShareNumbers;
  return {"filter-and-lens-of-one-pair",
          "streams",
          "one pair of numbers used twice: the class of SORT #35",
          {mean_claim(lens_crossings<Wrong>()), mean_claim<Packet>(lens_crossings<Wrong>())}};
}

}  // namespace

std::vector<Fault> camera_faults() {
  return {crowded_aperture(), square_aperture(),    unnormalised_gaussian(),
          spherical_focus(),  rays_about_corners(), rays_that_share_numbers()};
}

}  // namespace fairlight
