#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fairlight {

/// A rectangle of pixels: columns x0 .. x1 - 1 and rows y0 .. y1 - 1, in the coordinates of a
/// file's data window.
struct PixelWindow {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  bool contains(const PixelWindow& other) const {
    return x0 <= other.x0 && y0 <= other.y0 && x1 >= other.x1 && y1 >= other.y1;
  }
  bool operator==(const PixelWindow&) const = default;
};

/// How a picture says how noisy its pixels are.
enum class ErrorLayer {
  none,
  standard_error,  ///< of the pixel's mean: `error.R` of fairlight
  variance,        ///< of one sample: `Variance.R` of pbrt's GBufferFilm
  second_moment,   ///< of one sample, the mean of x^2: `m2_NAME.X` of Mitsuba's moment integrator
};

/// Values of a window of one picture, each plane with rows from the top.
struct PixelBlock {
  std::array<std::vector<float>, 3> colour;
  std::array<std::vector<float>, 3> error;  ///< as the file's ErrorLayer says; empty where it has none
  std::vector<float> samples;               ///< samples a pixel; empty where no layer says
};

/// The colour of an OpenEXR file of any renderer: scan lines or tiles, one part or several, half or
/// float, with the names of layers. It is read a block of rows at a time, so memory does not grow
/// with the picture. Errors throw std::runtime_error: one sentence with the file's name.
class PictureFile {
 public:
  /// Opens the file and chooses the colour: the channels R, G, B of the layer or part `layer`, or
  /// without a name the only ones there are. A file of nothing but R, G, B needs no name. With
  /// `with_errors`, a layer X, Y, Z of Mitsuba's moment integrator comes first. Rejects deep,
  /// luminance-chroma, subsampled and truncated files, and pictures of more than 65536 pixels a
  /// side.
  explicit PictureFile(const std::string& path, const std::string& layer = "", bool with_errors = false);
  ~PictureFile();
  PictureFile(PictureFile&&) noexcept;

  const std::string& path() const;
  PixelWindow data_window() const;
  /// The full names of the colour's three channels.
  const std::array<std::string, 3>& channels() const;
  /// R, G, B or X, Y, Z, without the layer.
  std::string channel_letters() const;
  /// x and y of red, green, blue and white. The file's, or those of Rec. 709, which OpenEXR
  /// assumes.
  const std::array<double, 8>& chromaticities() const;
  /// Whether a channel of the colour is stored in 16 bits.
  bool half() const;
  ErrorLayer error_layer() const;
  /// Samples a pixel, as pbrt's attribute `samplesPerPixel` says.
  std::optional<double> samples_per_pixel() const;
  /// A text attribute of the chosen part; empty if there is none.
  std::string attribute(const std::string& name) const;

  /// Reads the pixels of a window, which must lie in the data window.
  PixelBlock read(const PixelWindow& window);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fairlight
