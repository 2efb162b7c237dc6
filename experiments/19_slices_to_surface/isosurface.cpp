// SPDX-License-Identifier: GPL-3.0-or-later
#include "19_slices_to_surface/isosurface.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <stdexcept>
#include <string>

#include "harness/build_info.hpp"
#include "harness/provenance.hpp"
#include "mesh/io.hpp"

namespace impinge::lab {
namespace {

namespace fs = std::filesystem;

// A new folder for the files of the script, removed together with them.
class Exchange {
 public:
  Exchange() {
    std::string name = (fs::temp_directory_path() / "impinge-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + " cannot be made");
    folder_ = name;
  }
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;
  ~Exchange() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  fs::path file(const char* name) const { return folder_ / name; }

  // The mesh that a task of the script makes from a file.
  TriangleMesh made(const char* task, const fs::path& source, double number) const {
    const fs::path script =
        fs::path(build_info().source_folder) / "experiments/19_slices_to_surface/isosurface.py";
    const fs::path mesh = file("made.ply");
    std::string command = shell_quoted(build_info().python) + " -B";
    for (const std::string& word :
         {script.string(), std::string(task), source.string(), std::to_string(number), mesh.string()})
      command += " " + shell_quoted(word);
    if (std::system(command.c_str()) != 0) throw std::runtime_error("this command failed: " + command);
    return read_mesh(mesh);
  }

 private:
  fs::path folder_;
};

// MetaImage: a head in text, then the values as they lie in the memory of a little-endian machine.
void write_image(const fs::path& file, const VoxelImage& image) {
  std::ofstream out(file, std::ios::binary);
  out << std::setprecision(17) << "ObjectType = Image\nNDims = 3\nBinaryData = True\n"
      << "BinaryDataByteOrderMSB = False\nDimSize = " << image.count[0] << ' ' << image.count[1] << ' '
      << image.count[2] << "\nElementSpacing = " << image.spacing.transpose()
      << "\nOffset = " << image.origin.transpose() << "\nElementType = MET_FLOAT\nElementDataFile = LOCAL\n";
  out.write(reinterpret_cast<const char*>(image.values.data()),
            static_cast<std::streamsize>(image.values.size() * sizeof(float)));
  if (!out.flush()) throw std::runtime_error(file.string() + " cannot be written");
}

}  // namespace

TriangleMesh isosurface(const VoxelImage& image, double level) {
  if (image.values.size() != image.size()) {
    throw std::invalid_argument("an image needs as many values as it has voxels");
  }
  const Exchange exchange;
  write_image(exchange.file("image.mha"), image);
  return exchange.made("surface", exchange.file("image.mha"), level);
}

TriangleMesh decimate(const TriangleMesh& mesh, std::size_t faces) {
  if (mesh.faces.size() <= faces) return mesh;
  const Exchange exchange;
  write_mesh(exchange.file("mesh.ply"), mesh);
  return exchange.made("fewer", exchange.file("mesh.ply"), static_cast<double>(faces));
}

}  // namespace impinge::lab
