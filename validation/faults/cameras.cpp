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

Fault spherical_focus() {
  std::vector<Claim> claims;
  add_constant(claims, lens_focus<faults::SphericalFocus>());
  add_independent_mean(claims, circle_of_confusion<CircularAperture, faults::SphericalFocus>(0.75));
  return {"focus-along-the-ray", "measure",
          "a distance along the ray for one along the axis: the class of Baikal #82", claims};
}

}  // namespace

std::vector<Fault> camera_faults() {
  using Corners = faults::RaysAboutCorners;
  return {{"aperture-without-root",
           "Montelight",
           "the class of Smerity/montelight-cpp",
           {law_moments_claim(circular_aperture_law<faults::CrowdedAperture>()),
            confusion_behind<faults::CrowdedAperture>()}},
          {"aperture-square", "lens", "the class of pbrt-v3 #162", {confusion_behind<faults::SquareAperture>()}},
          {"gaussian-not-renormalised",
           "support",
           "the class of pbrt-v3 #319",
           {law_claim(gaussian_law<faults::UnnormalisedGaussian>())}},
          spherical_focus(),
          {"pixel-corner", "filter",
           "half a pixel lost: the class of Heckbert 1990, \"What are the coordinates of a pixel?\"",
           both(pinhole_crossings<Corners>(), lens_crossings<Corners>())},
          {"filter-and-lens-of-one-pair", "streams", "one pair of numbers used twice: the class of SORT #35",
           both(lens_crossings<faults::RaysThatShareNumbers>())},
          {"pupil-without-area",
           "lens",
           "pbrt-v3 #162",
           {constant_claim<double>(uniform_field_of_disk<faults::PupilWithoutArea>())}}};
}

}  // namespace fairlight
