#include "Readers/FileError.h"
#include "Readers/Formats/MincFile.h"
#include "Readers/Parsing/HeaderText.h"

#include <netcdf.h>
#include <netcdf_mem.h>

namespace varimarch
{
namespace
{

class Minc1File : public MincFile
{
public:
  explicit Minc1File(const std::string& path);
  ~Minc1File() override { nc_close(this->file); }

  void ReadImage(const MincPart& part, void* destination) override
  {
    this->Require(
      nc_get_vara(this->file, this->image, part.start.data(), part.count.data(), destination));
  }

  std::vector<double> ReadExtremes(const std::string& name, const MincPart& part) override
  {
    std::size_t count = 1;
    for (const std::size_t length : part.count)
    {
      count *= length;
    }
    std::vector<double> values(count);
    const int variable = this->Variable(name);
    this->RequireRank(name, variable, part.count.size());
    this->Require(nc_get_vara_double(
      this->file, variable, part.start.data(), part.count.data(), values.data()));
    return values;
  }

private:
  void Require(int status) const
  {
    if (status != NC_NOERR)
    {
      FailToRead(
        this->path, "a MINC image in netCDF", "the fault " + Quoted(nc_strerror(status), 160));
    }
  }

  // netCDF reads as many indices as the variable has axes.
  void RequireRank(const std::string& name, int variable, std::size_t expected) const
  {
    int rank = 0;
    this->Require(nc_inq_varndims(this->file, variable, &rank));
    if (std::size_t(rank) != expected)
    {
      FailToRead(this->path, name + " along " + std::to_string(expected) + " axes, as image-max",
        std::to_string(rank));
    }
  }

  int Variable(const std::string& name) const
  {
    int variable = -1;
    return nc_inq_varid(this->file, name.c_str(), &variable) == NC_NOERR ? variable : -1;
  }

  std::string Text(int variable, const char* name) const;
  std::vector<double> Numbers(int variable, const char* name) const;
  void TakeType();
  MincAxis Axis(int dimension) const;

  std::string path;
  /// The file. If netCDF reads it from the disk, it fills voxels behind its end with 0.
  std::string bytes;
  int file = -1;
  int image = -1;
};

std::string Minc1File::Text(int variable, const char* name) const
{
  nc_type type = NC_NAT;
  std::size_t length = 0;
  if (nc_inq_att(this->file, variable, name, &type, &length) != NC_NOERR || type != NC_CHAR)
  {
    return "";
  }
  std::string text(length, '\0');
  this->Require(nc_get_att_text(this->file, variable, name, text.data()));
  return text.substr(0, text.find('\0'));
}

std::vector<double> Minc1File::Numbers(int variable, const char* name) const
{
  nc_type type = NC_NAT;
  std::size_t length = 0;
  if (nc_inq_att(this->file, variable, name, &type, &length) != NC_NOERR || type == NC_CHAR)
  {
    return {};
  }
  std::vector<double> numbers(length);
  this->Require(nc_get_att_double(this->file, variable, name, numbers.data()));
  return numbers;
}

void Minc1File::TakeType()
{
  nc_type type = NC_NAT;
  this->Require(nc_inq_vartype(this->file, this->image, &type));
  this->Require(nc_inq_type(this->file, type, nullptr, &this->valueBytes));
  const std::string sign = this->Text(this->image, "signtype");
  const bool isSigned = sign.empty() ? type != NC_BYTE : sign.compare(0, 6, "signed") == 0;
  const bool isFloat = type == NC_FLOAT || type == NC_DOUBLE;
  this->kind = isFloat ? NumberKind::Float : isSigned ? NumberKind::Signed : NumberKind::Unsigned;
  std::vector<double> range = this->Numbers(this->image, "valid_range");
  if (range.size() != 2)
  {
    range = this->Numbers(this->image, "valid_min");
    const std::vector<double> end = this->Numbers(this->image, "valid_max");
    range.insert(range.end(), end.begin(), end.end());
  }
  if (range.size() == 2)
  {
    this->validRange = { range[0], range[1] };
  }
}

MincAxis Minc1File::Axis(int dimension) const
{
  MincAxis axis;
  char name[NC_MAX_NAME + 1] = {};
  this->Require(nc_inq_dim(this->file, dimension, name, &axis.length));
  axis.name = name;
  const int variable = this->Variable(name);
  if (variable < 0)
  {
    return axis;
  }
  const std::vector<double> start = this->Numbers(variable, "start");
  const std::vector<double> step = this->Numbers(variable, "step");
  const std::vector<double> cosines = this->Numbers(variable, "direction_cosines");
  axis.startMm = start.empty() ? 0.0 : start.front();
  axis.stepMm = step.empty() ? 1.0 : step.front();
  axis.hasStep = !step.empty();
  if (cosines.size() == 3)
  {
    axis.cosines = glm::dvec3(cosines[0], cosines[1], cosines[2]);
  }
  axis.isIrregular = this->Text(variable, "spacing").compare(0, 9, "irregular") == 0;
  return axis;
}

Minc1File::Minc1File(const std::string& path)
  : path(path)
  , bytes(WholeFile(path))
{
  this->storedBytes = double(this->bytes.size());
  this->Require(
    nc_open_mem(path.c_str(), NC_NOWRITE, this->bytes.size(), this->bytes.data(), &this->file));
  this->image = this->Variable("image");
  if (this->image < 0)
  {
    nc_close(this->file);
    FailToRead(path, "the variable \"image\" of MINC", "another netCDF file");
  }
  this->TakeType();
  int rank = 0;
  this->Require(nc_inq_varndims(this->file, this->image, &rank));
  std::vector<int> dimensions(static_cast<std::size_t>(rank));
  this->Require(nc_inq_vardimid(this->file, this->image, dimensions.data()));
  for (const int dimension : dimensions)
  {
    this->axes.push_back(this->Axis(dimension));
  }
  const int largest = this->Variable("image-max");
  this->hasExtremes = largest >= 0 && this->Variable("image-min") >= 0;
  int extremeRank = 0;
  if (this->hasExtremes)
  {
    this->Require(nc_inq_varndims(this->file, largest, &extremeRank));
  }
  this->extremeRank = std::size_t(extremeRank);
}

}

std::unique_ptr<MincFile> OpenMinc1(const std::string& path)
{
  return std::make_unique<Minc1File>(path);
}

}
