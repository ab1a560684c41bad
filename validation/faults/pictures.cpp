#include <fairlight/validation/claims/edge_pictures.h>
#include <fairlight/validation/claims/floor_pictures.h>
#include <fairlight/validation/claims/picture_covariances.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_films.h>

namespace fairlight {
namespace {

constexpr Arithmetic packets = Arithmetic::packets, doubles = Arithmetic::doubles;

// The claims about the picture of this name, with a wrong renderer.
template <class Wrong>
std::vector<Claim> floor_by(const std::string& name) {
  std::vector<Claim> claims;
  for (const FloorPicture& picture : floor_pictures()) {
    if (picture.name == name) claims.push_back(floor_picture<Wrong>(picture));
  }
  return claims;
}

template <class Wrong>
std::vector<Claim> edges_by(const std::string& name) {
  std::vector<Claim> claims;
  for (const EdgePicture& picture : edge_pictures()) {
    if (picture.name.starts_with(name) && picture.filter != PixelFilter::tent)
      claims.push_back(edge_picture<Wrong>(picture));
  }
  return claims;
}

template <class Wrong>
std::vector<Claim> parts_by(Rendering rendering) {
  return {variance_of_parts<Wrong>(doubles, rendering, 66), variance_of_parts<Wrong>(packets, rendering, 192)};
}

}  // namespace

// Faults of pictures whose every path is right.
std::vector<Fault> picture_faults() {
  using Wrapped = faults::SampleNumbersWrapAt64;
  const std::string place = "place in the picture", repeated = "reused number", sort = "the class of SORT #35";
  return {
      {"pixels-stored-by-columns", place, "mitsuba2 #24", floor_by<faults::StoredByColumns>("landscape")},
      {"rows-from-below", place, "raytracing.github.io #1076", floor_by<faults::UpsideDown>("portrait")},
      {"left-and-right-exchanged", place, "pytorch3d #78", floor_by<faults::Mirrored>("landscape")},
      {"pixels-about-corners", place, "Heckbert 1990, \"What are the coordinates of a pixel?\"",
       floor_by<faults::PixelsAboutCorners>("landscape")},
      {"field-of-view-along-the-width", place, "the class of Mitsuba's fov_axis",
       floor_by<faults::FieldOfViewAlongTheWidth>("landscape")},
      {"last-row-lost", place, "the class of three-gpu-pathtracer #508", floor_by<faults::LastRowLost>("odd")},
      {"blue-first", "channels", "rviz_camera_stream #21", floor_by<faults::BlueFirst>("landscape")},
      {"normalised-by-whole-tiles", "filter", "none: a sum of weights that a picture's edge cuts",
       floor_by<faults::NormalisedByWholeTiles>("landscape")},
      {"always-a-tent", "strategy off", "none: a setting that does not arrive",
       edges_by<faults::AlwaysTent>("pinhole")},
      {"blades-not-turned", "lens", "none: a setting that does not arrive",
       edges_by<faults::BladesNotTurned>("triangle")},
      {"blades-turned-back", "lens", "none: an angle of the other sign",
       edges_by<faults::BladesTurnedBack>("triangle")},
      {"aperture-of-twice-the-radius", "lens", "none: a diameter for a radius",
       edges_by<faults::DiameterForRadius>("circle")},
      {"pixel-numbers-by-height",
       "streams",
       "none: x + y * height for x + y * width",
       {variance_of_pictures<faults::NumbersByHeight>(doubles, 19, 11),
        variance_of_pictures<faults::NumbersByHeight>(packets, 27, 18)}},
      {"tiles-share-numbers",
       "streams",
       "the class of scrimage #508",
       {variance_of_pictures<faults::NumbersOfOneTile>(doubles, 19, 11),
        variance_of_pictures<faults::NumbersOfOneTile>(packets, 27, 18)}},
      {"sample-numbers-wrap-at-64",
       repeated,
       sort,
       {uncorrelated_samples<Wrapped>(doubles), uncorrelated_samples<Wrapped>(packets),
        variance_of_parts<Wrapped>(packets, Rendering::at_once, 256)}},
      {"sample-numbers-of-32-bits",
       repeated,
       sort,
       {uncorrelated_samples<faults::SampleNumbersOf32Bits>(doubles),
        uncorrelated_samples<faults::SampleNumbersOf32Bits>(packets)}},
      {"resumed-from-the-start", repeated, sort, parts_by<faults::ResumedFromTheStart>(Rendering::resumed)},
      {"shards-of-the-same-samples", repeated, sort, parts_by<faults::ResumedFromTheStart>(Rendering::ranges)},
      {"shards-of-one-seed", repeated, "the class of PsyNeuLink #3358",
       parts_by<faults::SeedsThroughDoubles>(Rendering::seeds)},
  };
}

}  // namespace fairlight
