#include <fairlight/render/contact_sheet.h>

namespace fairlight {

Film contact_sheet(int size, std::uint64_t samples, std::uint64_t seed, int threads, const Progress& progress) {
  constexpr int columns = 3;
  const std::vector<std::string> names = scene_names();
  const int scenes = static_cast<int>(names.size());
  Film sheet(columns * size, (scenes + columns - 1) / columns * size);
  for (int i = 0; i < scenes; ++i) {
    RenderSettings settings;
    settings.scene = names[static_cast<std::size_t>(i)];
    settings.width = settings.height = size;
    settings.direct = DirectLighting::mis;
    settings.which_light = WhichLight::contribution;
    Film film(size, size);
    render_image(view_of(settings), settings, seed, {0, samples}, threads, film, [&](double part) {
      if (progress) progress((i + part) / scenes);
    });
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) sheet.at(i % columns * size + x, i / columns * size + y) = film.at(x, y);
    }
  }
  return sheet;
}

}  // namespace fairlight
