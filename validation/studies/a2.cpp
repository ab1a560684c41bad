#include <fairlight/stats/text.h>
#include <fairlight/validation/claims/closed_scenes.h>
#include <fairlight/validation/faults/wrong_direct_light.h>
#include <fairlight/validation/studies/all_studies.h>
#include <fairlight/validation/studies/closed_forms.h>
#include <fairlight/validation/studies/pictures.h>
#include <fairlight/validation/studies/scenes.h>
#include <fairlight/validation/studies/traced_pictures.h>

namespace fairlight::studies_of_paper {
namespace {

template <class Direct>
using Tracer = PathTracer<BouncesBy<CosineHemisphere>, Direct, RouletteByReflectance<>>;

struct Films {
  Film right, twice;
};

// The same picture by shadow rays alone, and with emission besides.
Films films(const View& view, const StudyOptions& options, int size, std::uint64_t samples, const char* scene,
            std::uint32_t replicate) {
  const auto film = [&](const auto& tracer, const char* how) {
    const StreamKey key(replicate_seed(options, formatted("a2 %s %s", scene, how), replicate), "picture");
    return trace_picture(view, tracer, {size, size, samples, key}, options.threads, as_it_is);
  };
  return {film(Tracer<DirectLight<AllLights>>(), "right"), film(Tracer<faults::EmissionTwice>(), "twice")};
}

// Off the light nothing emits, so all radiance is reflected: the closed form of the ratio is 2.
std::vector<Cell> box_row(const StudyOptions& options, std::uint32_t replicates, Steps& steps) {
  const View box = box_with_light(8.5);
  const int size = options.quick ? 32 : 64;
  const std::vector<bool> counted = pixels_off_lights(box, size, size);
  std::vector<double> right, twice;
  for (std::uint32_t replicate = 0; replicate < replicates; ++replicate) {
    const Films both = films(box, options, size, options.quick ? 16 : 64, "box", replicate);
    right.push_back(mean_radiance(both.right, counted).mean());
    twice.push_back(mean_radiance(both.twice, counted).mean());
    steps.done();
  }
  return {"box, off the light",
          measured_mean(right),
          "none",
          measured_mean(twice),
          "none",
          measured_ratio(twice, right),
          closed_forms::double_counted(1, 0)};
}

std::vector<Cell> furnace_row(const StudyOptions& options, std::uint32_t replicates, Steps& steps) {
  const ClosedScene furnace = concentric_spheres();
  const double radiance = furnace.radiance(1000).mean(), emitted = furnace.view.scene.surfaces()[0].radiance.mean();
  const int size = 16;
  const std::vector<bool> all(static_cast<std::size_t>(size * size), true);
  std::vector<double> right, twice;
  for (std::uint32_t replicate = 0; replicate < replicates; ++replicate) {
    const Films both = films(furnace.view, options, size, options.quick ? 64 : 512, "furnace", replicate);
    right.push_back(mean_radiance(both.right, all).mean());
    twice.push_back(mean_radiance(both.twice, all).mean());
    steps.done();
  }
  const double closed = closed_forms::double_counted(radiance, emitted);
  return {"between concentric spheres", measured_mean(right), radiance, measured_mean(twice), closed,
          measured_ratio(twice, right), closed / radiance};
}

StudyPicture pictures(const StudyOptions& options, Steps& steps) {
  Films both =
      films(box_with_light(8.5), options, options.quick ? 160 : 224, options.quick ? 16 : 128, "picture", 0);
  steps.done();
  return write_montage(options, "a2",
                       "The reflected light is twice as bright where it is counted twice; the light itself "
                       "is not.",
                       {{both.right, "shadow rays alone"}, {both.twice, "emission counted besides"}}, 2, "", 0.7);
}

}  // namespace

StudyResult a2(const StudyOptions& options) {
  const std::uint32_t replicates = options.quick ? 6 : 24;
  Steps steps(options, 2 * replicates + 1);
  StudyResult result;
  result.text =
      "Shadow rays find the light of luminaires. A tracer that also counts emission where a bounce hits it adds "
      "the same "
      "light again. With the transport operator T the radiance is L = Le + T L; counted twice it is L' = Le + T Le "
      "+ T L' = "
      "2 L - Le. So all reflected light doubles, in every scene.";
  StudyTable table{
      "double-count",
      "Mean radiance, and the ratio of the two.",
      {{"scene"}, {"right"}, {"closed form"}, {"counted twice"}, {"closed form"}, {"ratio"}, {"closed form"}},
      {}};
  table.rows = {box_row(options, replicates, steps), furnace_row(options, replicates, steps)};
  result.tables.push_back(table);
  result.pictures.push_back(pictures(options, steps));
  return result;
}

}  // namespace fairlight::studies_of_paper
