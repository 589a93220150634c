#include "PhantomLibraryFiles.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <hdf5.h>
#include <netcdf.h>

#include <algorithm>
#include <iterator>

namespace
{

const char* const names[3] = { "xspace", "yspace", "zspace" };

/// The axes in RAS: lengths, directions, and the starts along these directions.
struct MincAxes
{
  explicit MincAxes(const StoredVolume& volume)
  {
    const glm::dvec3 lpsFromRas(-1.0, -1.0, 1.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->stepMm[axis] = glm::length(volume.axesMm[axis]);
      this->cosines[axis] = lpsFromRas * volume.axesMm[axis] / this->stepMm[axis];
    }
    this->startMm = glm::inverse(this->cosines) * (lpsFromRas * volume.originMm);
  }

  glm::dvec3 stepMm;
  glm::dvec3 startMm;
  glm::dmat3 cosines;
};

constexpr double validRange[2] = { -100.0, 100.0 };

/// The extremes of slices, or of the volume if it is not scaled: real values are then stored ones.
std::vector<double> Extremes(const StoredVolume& volume, const MincOptions& options, int end)
{
  std::vector<double> extremes;
  const int count = options.isScaled ? volume.dimensions[2] * std::max(1, options.timeCount) : 1;
  for (int i = 0; i < count; ++i)
  {
    extremes.push_back(
      options.isScaled ? MincReal(validRange[end], i % volume.dimensions[2]) : validRange[end]);
  }
  return extremes;
}

std::vector<double> ValuesOfTimes(const StoredVolume& volume, const MincOptions& options)
{
  std::vector<double> values;
  for (int time = 0; time < std::max(1, options.timeCount); ++time)
  {
    std::transform(volume.values.begin(), volume.values.end(), std::back_inserter(values),
      [time](double value) { return value + 100.0 * time; });
  }
  return values;
}

/// Makes the dimension of time.
int TimeOfMinc1(int file, const MincOptions& options)
{
  int dimension = -1;
  nc_def_dim(file, "time", std::size_t(options.timeCount), &dimension);
  int variable = -1;
  nc_def_var(file, "time", NC_INT, 0, nullptr, &variable);
  if (options.timeStepSeconds > 0.0)
  {
    nc_put_att_double(file, variable, "step", NC_DOUBLE, 1, &options.timeStepSeconds);
  }
  return dimension;
}

}

double MincReal(double stored, int slice)
{
  return (stored * 0.5 + 7.0) * (slice + 1);
}

void WriteMinc1(const std::string& path, const StoredVolume& volume, const MincOptions& options)
{
  const MincAxes axes(volume);
  int file = -1;
  nc_create(path.c_str(), NC_CLOBBER, &file);
  std::vector<int> dimensions;
  if (options.timeCount > 0)
  {
    dimensions.push_back(TimeOfMinc1(file, options));
  }
  for (int axis = 2; axis >= 0; --axis)
  {
    dimensions.push_back(-1);
    nc_def_dim(file, names[axis], std::size_t(volume.dimensions[axis]), &dimensions.back());
    int variable = -1;
    nc_def_var(file, names[axis], NC_INT, 0, nullptr, &variable);
    nc_put_att_double(file, variable, "step", NC_DOUBLE, 1, &axes.stepMm[axis]);
    nc_put_att_double(file, variable, "start", NC_DOUBLE, 1, &axes.startMm[axis]);
    nc_put_att_double(file, variable, "direction_cosines", NC_DOUBLE, 3, &axes.cosines[axis][0]);
    nc_put_att_text(file, variable, "spacing", 9, "regular__");
  }
  const int extremeRank = options.isScaled ? int(dimensions.size()) - 2 : 0;
  const int minimumRank = extremeRank + (options.hasOddMinima ? 1 : 0);
  int extremes[2] = {};
  nc_def_var(file, "image-min", NC_DOUBLE, minimumRank, dimensions.data(), &extremes[0]);
  nc_def_var(file, "image-max", NC_DOUBLE, extremeRank, dimensions.data(), &extremes[1]);
  int image = -1;
  nc_def_var(file, "image", NC_SHORT, int(dimensions.size()), dimensions.data(), &image);
  nc_put_att_text(file, image, "signtype", 8, "signed__");
  nc_put_att_double(file, image, "valid_range", NC_DOUBLE, 2, validRange);
  nc_enddef(file);
  for (int end = options.hasOddMinima ? 1 : 0; end < 2; ++end)
  {
    nc_put_var_double(file, extremes[end], Extremes(volume, options, end).data());
  }
  const std::vector<double> values = ValuesOfTimes(volume, options);
  nc_put_var_double(file, image, values.data());
  nc_close(file);
}

namespace
{

void PutNumbers(hid_t object, const char* name, const double* numbers, hsize_t count)
{
  const hid_t space = H5Screate_simple(1, &count, nullptr);
  const hid_t attribute = H5Acreate(object, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, H5T_NATIVE_DOUBLE, numbers);
  H5Aclose(attribute);
  H5Sclose(space);
}

void PutText(hid_t object, const char* name, const std::string& text)
{
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, text.size());
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t attribute = H5Acreate(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, type, text.data());
  H5Aclose(attribute);
  H5Sclose(space);
  H5Tclose(type);
}

/// Makes a data set with its values. @returns the data set, still open
hid_t PutData(hid_t file, const std::string& name, hid_t type, const std::vector<hsize_t>& lengths,
  const std::vector<double>& values)
{
  const hid_t creation = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(creation, 1);
  const hid_t space = lengths.empty()
    ? H5Screate(H5S_SCALAR)
    : H5Screate_simple(int(lengths.size()), lengths.data(), nullptr);
  const hid_t data = H5Dcreate(file, name.c_str(), type, space, creation, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Sclose(space);
  H5Pclose(creation);
  return data;
}

/// Describes the dimension of time.
void PutTimeOfMinc2(hid_t file, const MincOptions& options)
{
  const hid_t dimension = PutData(file, "/minc-2.0/dimensions/time", H5T_STD_I32LE, {}, { 0.0 });
  if (options.timeStepSeconds > 0.0)
  {
    PutNumbers(dimension, "step", &options.timeStepSeconds, 1);
  }
  H5Dclose(dimension);
}

}

void WriteMinc2(const std::string& path, const StoredVolume& volume, const MincOptions& options)
{
  const MincAxes axes(volume);
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  std::vector<hsize_t> lengths;
  std::string order = options.timeCount > 0 ? "time," : "";
  if (options.timeCount > 0)
  {
    lengths.push_back(hsize_t(options.timeCount));
    PutTimeOfMinc2(file, options);
  }
  for (int axis = 2; axis >= 0; --axis)
  {
    lengths.push_back(hsize_t(volume.dimensions[axis]));
    order += std::string(names[axis]) + (axis > 0 ? "," : "");
    const hid_t dimension =
      PutData(file, std::string("/minc-2.0/dimensions/") + names[axis], H5T_STD_I32LE, {}, { 0.0 });
    PutNumbers(dimension, "step", &axes.stepMm[axis], 1);
    PutNumbers(dimension, "start", &axes.startMm[axis], 1);
    PutNumbers(dimension, "direction_cosines", &axes.cosines[axis][0], 3);
    PutText(dimension, "spacing", "regular__");
    H5Dclose(dimension);
  }
  const std::vector<hsize_t> extremeLengths(
    lengths.begin(), options.isScaled ? lengths.end() - 2 : lengths.begin());
  std::vector<hsize_t> minimumLengths = extremeLengths;
  std::vector<double> minima = Extremes(volume, options, 0);
  if (options.hasOddMinima)
  {
    minimumLengths.push_back(2);
    minima.resize(2 * minima.size());
  }
  const std::string folder = "/minc-2.0/image/0/";
  H5Dclose(PutData(file, folder + "image-min", H5T_IEEE_F64LE, minimumLengths, minima));
  H5Dclose(PutData(
    file, folder + "image-max", H5T_IEEE_F64LE, extremeLengths, Extremes(volume, options, 1)));
  const hid_t image =
    PutData(file, folder + "image", H5T_STD_I16LE, lengths, ValuesOfTimes(volume, options));
  PutNumbers(image, "valid_range", validRange, 2);
  PutText(image, "dimorder", order);
  H5Dclose(image);
  H5Fclose(file);
}
