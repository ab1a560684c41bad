#include <fairlight/validation/claims/camera.h>
#include <fairlight/validation/claims/lens.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_cameras.h>

namespace fairlight {

namespace {

template <template <class> class Aperture>
Claim confusion_behind() {
  return mean_claim<Packet>(circle_of_confusion<Aperture, ThinLens>(3.5));
}

Fault crowded_aperture() {
  return {"aperture-without-root",
          "Montelight",
          "the class of Smerity/montelight-cpp",
          {law_moments_claim(circular_aperture_law<faults::CrowdedAperture>()),
           confusion_behind<faults::CrowdedAperture>()}};
}

Fault square_aperture() {
  return {"aperture-square", "lens", "the class of pbrt-v3 #162", {confusion_behind<faults::SquareAperture>()}};
}

Fault unnormalised_gaussian() {
  const auto law = gaussian_law<faults::UnnormalisedGaussian>();
  return {"gaussian-not-renormalised", "support", "the class of pbrt-v3 #319", {law_claim(law)}};
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

Fault pupil_without_area() {
  constexpr double radius = 0.375;
  return {"pupil-without-area",
          "lens",
          "pbrt-v3 #162",
          {uniform_field_claim("aperture.circle.uniform_field", "", faults::PupilWithoutArea<double>(radius),
                               std::numbers::pi * radius * radius)}};
}

}  // namespace

std::vector<Fault> camera_faults() {
  return {crowded_aperture(),   square_aperture(),         unnormalised_gaussian(), spherical_focus(),
          rays_about_corners(), rays_that_share_numbers(), pupil_without_area()};
}

}  // namespace fairlight
