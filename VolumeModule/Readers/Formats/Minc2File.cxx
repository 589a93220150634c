#include "Readers/FileError.h"
#include "Readers/Formats/MincFile.h"
#include "Readers/Parsing/Hdf5Handles.h"

#include <algorithm>

namespace varimarch
{
namespace
{

constexpr const char* imageName = "/minc-2.0/image/0/image";

class Minc2File : public MincFile
{
public:
  explicit Minc2File(const std::string& path);

  void ReadImage(const MincPart& part, void* destination) override
  {
    const Hdf5Handle type(H5Tget_native_type(this->imageType, H5T_DIR_ASCEND), H5Tclose);
    this->Read(this->image, part, type, destination);
  }

  std::vector<double> ReadExtremes(const std::string& name, const MincPart& part) override
  {
    const Hdf5Handle dataset(
      H5Dopen(this->file, ("/minc-2.0/image/0/" + name).c_str(), H5P_DEFAULT), H5Dclose);
    std::size_t count = 1;
    for (const std::size_t length : part.count)
    {
      count *= length;
    }
    std::vector<double> values(count);
    this->Read(dataset, part, H5T_NATIVE_DOUBLE, values.data());
    return values;
  }

private:
  void Require(bool isRight, const std::string& expected) const
  {
    if (!isRight)
    {
      FailToRead(this->path, expected, "a damaged or another HDF5 file");
    }
  }

  void Read(hid_t dataset, const MincPart& part, hid_t type, void* destination) const;
  std::vector<double> Numbers(hid_t object, const char* name) const;
  std::string Text(hid_t object, const char* name) const;
  std::size_t RankOf(const std::string& name) const;
  void TakeType();
  MincAxis Axis(const std::string& name, std::size_t length) const;

  std::string path;
  SilentHdf5 silent;
  Hdf5Handle file;
  Hdf5Handle image;
  Hdf5Handle imageType;
};

void Minc2File::Read(hid_t dataset, const MincPart& part, hid_t type, void* destination) const
{
  const SilentHdf5 silentHere;
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  const auto rank = int(part.count.size());
  this->Require(H5Sget_simple_extent_ndims(space) == rank,
    "image-min and image-max along as many axes"); // HDF5 reads as many indices as the data has
  const std::vector<hsize_t> start(part.start.begin(), part.start.end());
  const std::vector<hsize_t> count(part.count.begin(), part.count.end());
  const Hdf5Handle memory(
    rank > 0 ? H5Screate_simple(rank, count.data(), nullptr) : H5Screate(H5S_SCALAR), H5Sclose);
  const bool isSelected = rank == 0 ||
    H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) >= 0;
  this->Require(isSelected && H5Dread(dataset, type, memory, space, H5P_DEFAULT, destination) >= 0,
    "readable values of a MINC image");
}

std::vector<double> Minc2File::Numbers(hid_t object, const char* name) const
{
  if (object < 0 || H5Aexists(object, name) <= 0)
  {
    return {};
  }
  const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  const H5T_class_t kind = H5Tget_class(type);
  if (count < 1 || count > 16 || (kind != H5T_INTEGER && kind != H5T_FLOAT))
  {
    return {};
  }
  std::vector<double> numbers(static_cast<std::size_t>(count));
  this->Require(
    H5Aread(attribute, H5T_NATIVE_DOUBLE, numbers.data()) >= 0, std::string("numbers as ") + name);
  return numbers;
}

std::string Minc2File::Text(hid_t object, const char* name) const
{
  if (object < 0 || H5Aexists(object, name) <= 0)
  {
    return "";
  }
  const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
  const std::size_t length = H5Tget_size(type);
  if (H5Sget_simple_extent_npoints(space) != 1 || H5Tget_class(type) != H5T_STRING ||
    H5Tis_variable_str(type) > 0 || length > 65536)
  {
    return "";
  }
  std::string text(length, '\0');
  this->Require(H5Aread(attribute, type, text.data()) >= 0, std::string("a text as ") + name);
  return text.substr(0, text.find('\0'));
}

std::size_t Minc2File::RankOf(const std::string& name) const
{
  const Hdf5Handle dataset(H5Dopen(this->file, name.c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  return std::size_t(std::max(0, H5Sget_simple_extent_ndims(space)));
}

void Minc2File::TakeType()
{
  this->valueBytes = H5Tget_size(this->imageType);
  const H5T_class_t type = H5Tget_class(this->imageType);
  this->Require(type == H5T_INTEGER || type == H5T_FLOAT, "an image of real numbers");
  const Hdf5Handle native(H5Tget_native_type(this->imageType, H5T_DIR_ASCEND), H5Tclose);
  this->Require(native >= 0 && H5Tget_size(native) == this->valueBytes,
    "numbers of 1, 2, 4 or 8 bytes"); // others are read as larger ones
  const bool isSigned = type == H5T_INTEGER && H5Tget_sign(this->imageType) == H5T_SGN_2;
  this->kind = type == H5T_FLOAT ? NumberKind::Float
    : isSigned                   ? NumberKind::Signed
                                 : NumberKind::Unsigned;
  const std::vector<double> range = this->Numbers(this->image, "valid_range");
  if (range.size() == 2)
  {
    this->validRange = { range[0], range[1] };
  }
  const Hdf5Handle creation(H5Dget_create_plist(this->image), H5Pclose);
  this->isCompressed = H5Pget_nfilters(creation) > 0;
  this->storedBytes = double(H5Dget_storage_size(this->image));
}

MincAxis Minc2File::Axis(const std::string& name, std::size_t length) const
{
  MincAxis axis;
  axis.name = name;
  axis.length = length;
  const std::string path = "/minc-2.0/dimensions/" + name;
  const Hdf5Handle dimension(H5Dopen(this->file, path.c_str(), H5P_DEFAULT), H5Dclose);
  const std::vector<double> start = this->Numbers(dimension, "start");
  const std::vector<double> step = this->Numbers(dimension, "step");
  const std::vector<double> cosines = this->Numbers(dimension, "direction_cosines");
  axis.startMm = start.empty() ? 0.0 : start.front();
  axis.stepMm = step.empty() ? 1.0 : step.front();
  axis.hasStep = !step.empty();
  if (cosines.size() == 3)
  {
    axis.cosines = glm::dvec3(cosines[0], cosines[1], cosines[2]);
  }
  axis.isIrregular = this->Text(dimension, "spacing").compare(0, 9, "irregular") == 0;
  return axis;
}

Minc2File::Minc2File(const std::string& path)
  : path(path)
  , file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose)
  , image(this->file >= 0 ? H5Dopen(this->file, imageName, H5P_DEFAULT) : -1, H5Dclose)
  , imageType(this->image >= 0 ? H5Dget_type(this->image) : -1, H5Tclose)
{
  this->Require(this->file >= 0, "a complete HDF5 file");
  this->Require(this->imageType >= 0, std::string("the image of MINC, ") + imageName);
  this->TakeType();
  const Hdf5Handle space(H5Dget_space(this->image), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space);
  this->Require(rank >= 1 && rank <= 16, "an image of 1 to 16 dimensions");
  std::vector<hsize_t> lengths(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(space, lengths.data(), nullptr);
  std::string names = this->Text(this->image, "dimorder") + ',';
  for (const hsize_t length : lengths)
  {
    const std::size_t comma = std::min(names.find(','), names.size());
    this->axes.push_back(this->Axis(names.substr(0, comma), std::size_t(length)));
    names.erase(0, comma + 1);
  }
  this->hasExtremes = H5Lexists(this->file, "/minc-2.0/image/0/image-max", H5P_DEFAULT) > 0 &&
    H5Lexists(this->file, "/minc-2.0/image/0/image-min", H5P_DEFAULT) > 0;
  this->extremeRank = this->hasExtremes ? this->RankOf("/minc-2.0/image/0/image-max") : 0;
}

}

std::unique_ptr<MincFile> OpenMinc2(const std::string& path)
{
  return std::make_unique<Minc2File>(path);
}

}
