#include "cli/film.h"

#include <fmt/format.h>
#include <unistd.h>

#include "cli/command.h"
#include "cli/run_program.h"
#include "files/safe_file.h"

namespace flyrock::cli {

namespace fs = std::filesystem;

namespace {

/// A folder beside a file, for the frames of the film; it is removed.
class FrameFolder {
 public:
  explicit FrameFolder(const fs::path& film) {
    std::string name = (fs::absolute(film).parent_path() / ".frames-XXXXXX").string();
    if (!::mkdtemp(name.data()))
      throw InputError(
          fmt::format("{}: no file can be written there", fs::absolute(film).parent_path().string()));
    path = name;
  }
  FrameFolder(const FrameFolder&) = delete;
  FrameFolder& operator=(const FrameFolder&) = delete;
  ~FrameFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }

  fs::path path;
};

void convert(const std::string& picture, const fs::path& drawing, const fs::path& png, std::size_t width) {
  write_file(drawing, picture);
  if (!run_program({"rsvg-convert", "--width", std::to_string(width), "--keep-aspect-ratio", "--output",
                    png.string(), drawing.string()}))
    throw InputError(fmt::format("{}: rsvg-convert cannot write it", png.string()));
}

/// The filter that gives a GIF the colours of its own frames, and an MP4 the even sides that its codec asks
/// for.
std::vector<std::string> coding_of(const fs::path& file) {
  if (file.extension() == ".gif")
    return {"-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse", "-loop", "0"};
  return {"-vf",       "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-pix_fmt", "yuv420p", "-movflags",
          "+faststart"};
}

}  // namespace

bool is_film(const fs::path& file) {
  return file.extension() == ".png" || file.extension() == ".gif" || file.extension() == ".mp4";
}

void require_programs(const fs::path& file) {
  if (!has_program("rsvg-convert"))
    throw UsageError(
        fmt::format("{}: needs rsvg-convert (Debian: librsvg2-bin); or write FILE.svg, which "
                    "moves in a browser",
                    file.string()));
  if (file.extension() != ".png" && !has_program("ffmpeg"))
    throw UsageError(
        fmt::format("{}: needs ffmpeg (Debian: ffmpeg); or write FILE.svg, which moves in a "
                    "browser",
                    file.string()));
}

void film(const Frames& frames, const fs::path& file, std::size_t width) {
  const FrameFolder folder(file);
  const fs::path drawing = folder.path / "frame.svg";
  const bool is_png = file.extension() == ".png";
  const fs::path stem = is_png ? file.parent_path() / file.stem() : folder.path / "frame";
  for (std::size_t i = 0; i < frames.pictures.size(); ++i) {
    const bool alone = is_png && frames.pictures.size() == 1;
    const fs::path png = alone ? file : fs::path(fmt::format("{}-{:03}.png", stem.string(), i + 1));
    convert(frames.pictures[i], drawing, png, width);
    if (is_png) fmt::print("{}\n", png.string());
  }
  if (is_png) return;
  std::vector<std::string> words = {"ffmpeg",     "-v",
                                    "error",      "-y",
                                    "-framerate", fmt::format("{:g}", frames.rate),
                                    "-i",         (folder.path / "frame-%03d.png").string()};
  for (const std::string& word : coding_of(file)) words.push_back(word);
  words.push_back(file.string());
  if (!run_program(words)) throw InputError(fmt::format("{}: ffmpeg cannot write it", file.string()));
  fmt::print("{}\n", file.string());
}

}  // namespace flyrock::cli
