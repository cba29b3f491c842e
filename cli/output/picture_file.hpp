// Writes pictures: SVG, and by another program PNG and PDF.
#pragma once

#include <functional>
#include <string>

#include "output/output_file.hpp"

namespace minksum::cli {

/// Throws a Failure before any work if a picture of this name cannot be written: for standard
/// output, for endings but .svg, .png and .pdf, and for the last two without a program that makes
/// them. Messages name the option. An empty name is no picture.
void require_picture(const char* option, const std::string& file);

/// Writes a picture that `draw` returns as SVG, in the format in which the file's name ends.
void write_picture(OutputFiles& files, const std::string& file,
                   const std::function<std::string()>& draw);

}  // namespace minksum::cli
