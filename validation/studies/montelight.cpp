#include <fairlight/stats/text.h>
#include <fairlight/validation/studies/all_studies.h>
#include <fairlight/validation/studies/montelight_tracer.h>
#include <fairlight/validation/studies/pictures.h>
#include <fairlight/validation/studies/scenes.h>
#include <fairlight/validation/studies/traced_pictures.h>

namespace fairlight::studies_of_paper {
namespace {

struct Variant {
  const char* name;
  const char* caption;
  MontelightFaults faults;
};

const Variant variants[]{
    {"none", "right", {}},
    {"points uniform in theta", "theta", {.theta = true}},
    {"solid angle of a sphere of 1.5 m", "solid angle", {.solid_angle = true}},
    {"roulette unpaid", "roulette unpaid", {.roulette = true}},
    {"samples clamped", "samples clamped", {.clamped = true}},
    {"all four", "all four", {.theta = true, .solid_angle = true, .roulette = true, .clamped = true}},
};

// Every variant has the same numbers in a replicate, so that their differences have little noise.
Film film_of(const View& view, const Variant& variant, int size, std::uint64_t samples, const StudyOptions& options,
             std::uint32_t replicate) {
  const StreamKey key(replicate_seed(options, "montelight", replicate), "picture");
  return trace_picture(view, montelight_tracer(variant.faults, view.scene), {size, size, samples, key},
                       options.threads,
                       [&](const Rgb<double>& radiance) { return montelight_kept(variant.faults, radiance); });
}

StudyTable biases(double radius, const StudyOptions& options, Steps& steps, std::uint32_t replicates) {
  const View view = box_with_light(radius);
  const int size = options.quick ? 32 : 64;
  const std::vector<bool> counted = pixels_off_lights(view, size, size);
  std::vector<std::array<std::vector<double>, 3>> means(std::size(variants));
  for (std::uint32_t replicate = 0; replicate < replicates; ++replicate) {
    for (std::size_t i = 0; i < std::size(variants); ++i) {
      const Rgb<double> mean =
          mean_radiance(film_of(view, variants[i], size, options.quick ? 16 : 64, options, replicate), counted);
      for (std::size_t c = 0; c < 3; ++c) means[i][c].push_back(mean[static_cast<Eigen::Index>(c)]);
      steps.done();
    }
  }
  StudyTable table{
      formatted("radius-%g", radius),
      formatted("How much darker or brighter the picture is in the mean, in %%, with a light of radius %g m; "
                "pixels near the light left out.",
                radius),
      {{"fault"}, {"red in %"}, {"green in %"}, {"blue in %"}},
      {}};
  for (std::size_t i = 1; i < std::size(variants); ++i) {
    std::vector<Cell> row{variants[i].name};
    for (std::size_t c = 0; c < 3; ++c) row.emplace_back(in_percent(measured_ratio(means[i][c], means[0][c])));
    table.rows.push_back(row);
  }
  return table;
}

// Square tiles of this many pixels, in which the noise of single pixels is averaged out.
constexpr int tile = 8;

// The bias of each tile, averaged over the channels, in %.
std::vector<double> relative(const Film& wrong, const Film& right) {
  const auto sum = [](const Film& film, int left, int top) {
    double total = 0;
    for (int y = top; y < top + tile; ++y) {
      for (int x = left; x < left + tile; ++x) total += film.mean(x, y).mean();
    }
    return total;
  };
  std::vector<double> values;
  for (int y = 0; y + tile <= right.height(); y += tile) {
    for (int x = 0; x + tile <= right.width(); x += tile)
      values.push_back(100 * (sum(wrong, x, y) / sum(right, x, y) - 1));
  }
  return values;
}

std::vector<StudyPicture> pictures(const StudyOptions& options, Steps& steps) {
  const View view = box_with_light(1.5);
  const int size = options.quick ? 160 : 224;
  std::vector<Captioned> shown;
  for (const Variant& variant : variants) {
    shown.push_back({film_of(view, variant, size, options.quick ? 16 : 64, options, 1000), variant.caption});
    steps.done();
  }
  return {write_montage(options, "montelight",
                        "The paper's scene by the renderer of the paper, with each of its faults: "
                        "equal random numbers.",
                        shown, 3),
          write_map(options, "montelight-map",
                    formatted("Bias with all four faults in the paper's scene, in %%, by tiles of %d x %d pixels",
                              tile, tile),
                    relative(shown.back().film, shown.front().film), size / tile, "[-20:20]",
                    "defined (-1 blue, 0 'white', 1 red)")};
}

}  // namespace

StudyResult montelight(const StudyOptions& options) {
  const std::uint32_t replicates = options.quick ? 4 : 12;
  Steps steps(options, 2 * std::size(variants) * replicates + std::size(variants));
  StudyResult result;
  result.text =
      "The paper's renderer, Montelight, has four faults that its pictures do not show to the eye: points of a "
      "luminaire "
      "crowd at its poles, a shadow ray is weighted by the solid angle of a sphere of 1.5 m, survivors of roulette "
      "are not "
      "divided by their probability, and samples are cut at 1 before they are averaged. Here each is put into the "
      "right "
      "renderer. All variants have the same random numbers, so the differences are known better than the pictures.";
  for (const double radius : {1.5, 3.0}) result.tables.push_back(biases(radius, options, steps, replicates));
  result.pictures = pictures(options, steps);
  return result;
}

}  // namespace fairlight::studies_of_paper
