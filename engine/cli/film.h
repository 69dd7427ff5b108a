#pragma once
// Pictures for programs that do not animate SVG, by rsvg-convert and ffmpeg where they are installed.

#include <filesystem>

#include "report/pictures/animation.h"

namespace flyrock::cli {

/// Whether a file with this ending is written by `film`: .png, .gif, .mp4.
bool is_film(const std::filesystem::path& file);

/// Throws UsageError if a program that writes such a file is missing.
void require_programs(const std::filesystem::path& file);

/// Writes frames as a film, or as PNG: one frame into the file itself, several into files with numbers
/// (motion-001.png). `width`: pixels. Says what it wrote. Throws InputError.
void film(const Frames& frames, const std::filesystem::path& file, std::size_t width);

}  // namespace flyrock::cli
