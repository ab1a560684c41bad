#include <algorithm>
#include <cmath>
#include <ctime>

#include <fairlight/estimators/stream.h>
#include <fairlight/validation/studies/renders.h>

namespace fairlight {

std::uint64_t replicate_seed(const StudyOptions& options, const std::string& purpose, std::uint32_t replicate) {
  const auto words = StreamKey(options.seed, "study " + purpose).further(replicate).words();
  return std::uint64_t{words[1]} << 32 | words[0];
}

std::vector<bool> pixels_off_lights(const View& view, int width, int height, int margin) {
  std::vector<bool> counted;
  const CameraSettings& camera = view.camera.settings();
  const double around = (margin + 0.5) * camera.image_height / height;  // at distance 1
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Vec3<double> direction = view.camera.ray<double>(x + 0.5, y + 0.5, width, height).direction;
      counted.push_back(std::ranges::none_of(view.scene.luminaires(), [&](const Luminaire& light) {
        const Vec3<double> way = light.centre - camera.eye;
        const double along = way.dot(direction);
        return along > 0 && (way - along * direction).norm() <= light.radius + around * along;
      }));
    }
  }
  return counted;
}

namespace {

// The mean over the counted pixels of value(pixel), an Rgb.
template <class Value>
Rgb<double> mean_over(const Film& film, const std::vector<bool>& counted, const Value& value) {
  Rgb<double> sum(0, 0, 0);
  double n = 0;
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      if (!counted[static_cast<std::size_t>(y * film.width() + x)]) continue;
      sum += value(film.at(x, y));
      ++n;
    }
  }
  return sum / n;
}

}  // namespace

double square_error(const Film& film, const std::vector<bool>& counted) {
  const auto square = [](const ExactMoments& channel) {
    return channel.variance() / static_cast<double>(channel.count());
  };
  return mean_over(film, counted,
                   [&](const Film::Pixel& pixel) {
                     return Rgb<double>(square(pixel[0]), square(pixel[1]), square(pixel[2]));
                   })
      .mean();
}

Rgb<double> mean_radiance(const Film& film, const std::vector<bool>& counted) {
  return mean_over(film, counted, [](const Film::Pixel& pixel) {
    return Rgb<double>(pixel[0].mean(), pixel[1].mean(), pixel[2].mean());
  });
}

TimedFilm render_arm(const Arm& arm, const StudyOptions& options, std::uint32_t replicate) {
  TimedFilm timed{Film(arm.settings.width, arm.settings.height), 0};
  const std::clock_t start = std::clock();
  render_image(with_camera_of(arm.settings, arm.view), arm.settings, replicate_seed(options, arm.name, replicate),
               {0, arm.samples}, options.threads, timed.film, {});
  timed.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return timed;
}

std::vector<double> ArmRuns::costs() const {
  std::vector<double> costs;
  for (std::size_t i = 0; i < seconds.size(); ++i) costs.push_back(square_errors[i] * seconds[i]);
  return costs;
}

std::vector<ArmRuns> run_arms(const std::vector<Arm>& arms, const StudyOptions& options, std::uint32_t replicates,
                              Steps& steps) {
  std::vector<ArmRuns> runs(arms.size());
  std::vector<std::vector<bool>> counted;
  for (const Arm& arm : arms)
    counted.push_back(pixels_off_lights(arm.view, arm.settings.width, arm.settings.height));
  for (std::uint32_t replicate = 0; replicate < replicates; ++replicate) {
    for (std::size_t i = 0; i < arms.size(); ++i) {
      const auto [film, seconds] = render_arm(arms[i], options, replicate);
      const auto samples = static_cast<double>(arms[i].samples);
      runs[i].square_errors.push_back(square_error(film, counted[i]) * samples);
      runs[i].seconds.push_back(seconds / samples);
      runs[i].means.push_back(mean_radiance(film, counted[i]));
      steps.done();
    }
  }
  return runs;
}

Measured in_percent(const Measured& ratio) {
  return {100 * (ratio.value - 1), {100 * (ratio.interval.lo - 1), 100 * (ratio.interval.hi - 1)}};
}

Measured efficiency_ratio(const ArmRuns& a, const ArmRuns& b) { return measured_ratio(b.costs(), a.costs()); }

Measured variance_ratio(const ArmRuns& a, const ArmRuns& b) {
  return measured_ratio(a.square_errors, b.square_errors);
}

Measured time_ratio(const ArmRuns& a, const ArmRuns& b) { return measured_ratio(a.seconds, b.seconds); }

}  // namespace fairlight
