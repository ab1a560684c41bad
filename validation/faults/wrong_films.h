#pragma once

#include <algorithm>
#include <cstdint>

#include <fairlight/validation/claims/rendered_radiance.h>

/// Renderers that trace every path rightly, and put it at a wrong place of the picture or count it
/// wrongly. They take the place of the shipped one.
namespace fairlight::faults {

namespace detail {

/// A picture by the shipped renderer of which pixel (x, y) is taken from `from(x, y)`.
template <class From>
void render_moved(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                  Film& film, const From& from) {
  Film right(film.width(), film.height());
  ShippedRenderer::render(view, settings, seed, range, right);
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      const auto [column, row] = from(x, y);
      for (std::size_t c = 0; c < 3; ++c) film.at(x, y)[c].merge(right.at(column, row)[c]);
    }
  }
}

struct Place {
  int column, row;
};

}  // namespace detail

/// Pixels are written by columns and read by rows, so only a square picture is a plain transpose.
/// On record: mitsuba2 #24.
struct StoredByColumns {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    const int width = film.width(), height = film.height();
    detail::render_moved(view, settings, seed, range, film, [=](int x, int y) {
      const int place = y * width + x;
      return detail::Place{place / height, place % height};
    });
  }
};

/// Rows from the bottom up, as in OpenGL. On record: raytracing.github.io #1076.
struct UpsideDown {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    const int height = film.height();
    detail::render_moved(view, settings, seed, range, film, [=](int x, int y) {
      return detail::Place{x, height - 1 - y};
    });
  }
};

/// Left and right exchanged, by a camera's basis of the other handedness. On record: pytorch3d #78.
struct Mirrored {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    const int width = film.width();
    detail::render_moved(view, settings, seed, range, film, [=](int x, int y) {
      return detail::Place{width - 1 - x, y};
    });
  }
};

/// Pixels whose numbers x + y * height are equal have the same samples.
struct NumbersByHeight {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    const int width = film.width(), height = film.height();
    detail::render_moved(view, settings, seed, range, film, [=](int x, int y) {
      const int number = (x + y * height) % (width * height);
      return detail::Place{number % width, number / width};
    });
  }
};

/// Pixels are numbered within their tile, so all tiles have the samples of the first. On record:
/// the class of scrimage #508.
struct NumbersOfOneTile {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    detail::render_moved(view, settings, seed, range, film, [](int x, int y) {
      return detail::Place{x % 16, y % 16};
    });
  }
};

/// Blue comes first, as in OpenCV. On record: rviz_camera_stream #21.
struct BlueFirst {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    Film right(film.width(), film.height());
    ShippedRenderer::render(view, settings, seed, range, right);
    for (int y = 0; y < film.height(); ++y) {
      for (int x = 0; x < film.width(); ++x) {
        for (std::size_t c = 0; c < 3; ++c) film.at(x, y)[c].merge(right.at(x, y)[2 - c]);
      }
    }
  }
};

/// The last row of the last tiles is not traced, and stays black. On record: the class of
/// three-gpu-pathtracer #508.
struct LastRowLost {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    Film right(film.width(), film.height());
    ShippedRenderer::render(view, settings, seed, range, right);
    for (int y = 0; y + 1 < film.height(); ++y) {
      for (int x = 0; x < film.width(); ++x) {
        for (std::size_t c = 0; c < 3; ++c) film.at(x, y)[c].merge(right.at(x, y)[c]);
      }
    }
  }
};

/// The weights of a filter are normalised by the sum over a whole tile, also where a tile is cut by
/// the picture's edge.
struct NormalisedByWholeTiles {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    const auto share = [](int place, int size) { return std::min(16, size - place / 16 * 16) / 16.0; };
    for (std::uint64_t sample = range.first; sample < range.last; ++sample) {
      Film one(film.width(), film.height());
      ShippedRenderer::render(view, settings, seed, {sample, sample + 1}, one);
      for (int y = 0; y < film.height(); ++y) {
        for (int x = 0; x < film.width(); ++x)
          film.add(x, y, one.mean(x, y) * share(x, film.width()) * share(y, film.height()));
      }
    }
  }
};

/// The samples of a resumed picture, or of a shard, begin at 0 again.
struct ResumedFromTheStart {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    ShippedRenderer::render(view, settings, seed, {0, range.last - range.first}, film);
  }
};

/// Sample numbers of six bits.
struct SampleNumbersWrapAt64 {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    for (std::uint64_t sample = range.first; sample < range.last; ++sample)
      ShippedRenderer::render(view, settings, seed, {sample % 64, sample % 64 + 1}, film);
  }
};

/// Sample numbers of 32 bits.
struct SampleNumbersOf32Bits {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    const std::uint64_t low = range.first & 0xFFFFFFFFu;
    ShippedRenderer::render(view, settings, seed, {low, low + range.last - range.first}, film);
  }
};

/// Shards of consecutive seeds have the numbers of one: seeds pass through a double, which keeps 53
/// of their 64 bits, as in JSON. On record: the class of PsyNeuLink #3358.
struct SeedsThroughDoubles {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    const auto rounded = static_cast<std::uint64_t>(static_cast<double>(seed >> 11)) << 11;
    ShippedRenderer::render(view, settings, rounded, range, film);
  }
};

namespace detail {

/// Renders with changed optics: `change(camera)` gets the camera's settings.
template <class Change>
void render_through(View view, const RenderSettings& settings, std::uint64_t seed, SampleRange range, Film& film,
                    const Change& change) {
  CameraSettings camera = view.camera.settings();
  change(camera);
  view.camera = Camera(camera);
  ShippedRenderer::render(view, settings, seed, range, film);
}

}  // namespace detail

/// Pixels are sampled about their corners: everything is half a pixel to the right and down.
struct PixelsAboutCorners {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    detail::render_through(view, settings, seed, range, film, [&](CameraSettings& camera) {
      const double half = camera.image_height * camera.focus_distance / film.height() / 2;
      camera.eye += half * Vec3<double>(-1, 1, 0);  // of a camera that looks down
    });
  }
};

/// The field of view is along the width. On record: Mitsuba's `fov_axis`, whose default is x.
struct FieldOfViewAlongTheWidth {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    detail::render_through(view, settings, seed, range, film, [&](CameraSettings& camera) {
      camera.image_height *= static_cast<double>(film.height()) / film.width();
    });
  }
};

/// The blades of the aperture do not turn.
struct BladesNotTurned {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    detail::render_through(view, settings, seed, range, film,
                           [](CameraSettings& camera) { camera.blade_rotation = 0; });
  }
};

/// The blades turn the other way.
struct BladesTurnedBack {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    detail::render_through(view, settings, seed, range, film,
                           [](CameraSettings& camera) { camera.blade_rotation *= -1; });
  }
};

/// The diameter of the aperture is taken for its radius.
struct DiameterForRadius {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    detail::render_through(view, settings, seed, range, film,
                           [](CameraSettings& camera) { camera.aperture_radius *= 2; });
  }
};

/// Every picture is made with a tent filter, whatever was asked for.
struct AlwaysTent {
  static void render(const View& view, RenderSettings settings, std::uint64_t seed, SampleRange range, Film& film) {
    settings.filter = PixelFilter::tent;
    ShippedRenderer::render(view, settings, seed, range, film);
  }
};

}  // namespace fairlight::faults
