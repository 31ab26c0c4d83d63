#include "import/png_image.hpp"

#ifdef TAUT_HAS_PNG
#include <png.h>
#endif

#include <memory>
#include <vector>

#include "taut/error.hpp"

namespace taut::drawing {

namespace {

const char* const png_signature = "\x89PNG\r\n\x1a\n";
const char* const png_remedy = "save the image again, or as PGM: convert map.png map.pgm";

#ifdef TAUT_HAS_PNG
constexpr unsigned largest_side = 1 << 15;

GreyImage decoded_png(const std::string& bytes, const std::string& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  // What it holds is freed, whatever happens.
  const std::unique_ptr<png_image, void (*)(png_image*)> owner(&image, png_image_free);
  const auto require = [&](int well) {
    if (well == 0) throw InputError(file, std::string("the PNG cannot be read: ") + image.message, png_remedy);
  };
  require(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()));
  if (image.width > largest_side || image.height > largest_side)
    throw InputError(file, "the image has more than 32768 columns or rows", "cut the map into several ones");
  image.format = PNG_FORMAT_RGB;
  std::vector<png_byte> pixels(PNG_IMAGE_SIZE(image));
  // Where it is transparent, nothing is known of the map: between black and white.
  const png_color unknown{205, 205, 205};
  require(png_image_finish_read(&image, &unknown, pixels.data(), 0, nullptr));
  GreyImage grey{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  for (std::size_t k = 0; k < pixels.size(); k += 3)
    grey.grey.push_back((pixels[k] + pixels[k + 1] + pixels[k + 2]) / (3 * 255.0));
  return grey;
}
#endif

}  // namespace

std::optional<GreyImage> read_png(const std::string& bytes, const std::string& file) {
  if (bytes.compare(0, 8, png_signature, 8) != 0) return std::nullopt;
#ifdef TAUT_HAS_PNG
  return decoded_png(bytes, file);
#else
  throw InputError(file, "this program was built without libpng, and does not read PNG", png_remedy);
#endif
}

}  // namespace taut::drawing
