#include "Readers/Pyramids/Hdf5File.h"

#include "Readers/FileError.h"
#include "Readers/VoxelLayout.h"

#include <vtkType.h>

#include <algorithm>
#include <functional>

namespace varimarch
{
namespace
{

constexpr int MostHdf5Axes = 16;

/// Replaces the "%" of a pattern by a number.
std::string Numbered(std::string pattern, std::size_t number)
{
  const std::size_t place = pattern.find('%');
  return pattern.replace(place, 1, std::to_string(number));
}

std::vector<std::int64_t> SizeOfSpace(hid_t space)
{
  const int rank = H5Sget_simple_extent_ndims(space);
  if (rank < 1 || rank > MostHdf5Axes)
  {
    return {};
  }
  std::vector<hsize_t> sizes(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
  return { sizes.begin(), sizes.end() };
}

/// The type in memory of stored numbers. It may be smaller, since integers may leave bits unused.
Hdf5Handle MemoryTypeOf(hid_t stored)
{
  return { H5Tget_native_type(stored, H5T_DIR_ASCEND), H5Tclose };
}

int ScalarTypeOf(hid_t given)
{
  // Named numbers, such as the booleans of h5py, are integers.
  const bool isNamed = H5Tget_class(given) == H5T_ENUM;
  const Hdf5Handle type(isNamed ? H5Tget_super(given) : H5Tcopy(given), H5Tclose);
  const H5T_class_t kind = H5Tget_class(type);
  if (kind != H5T_INTEGER && kind != H5T_FLOAT)
  {
    return VTK_VOID;
  }
  const bool isSigned = kind == H5T_INTEGER && H5Tget_sign(type) == H5T_SGN_2;
  const NumberKind numbers = kind == H5T_FLOAT ? NumberKind::Float
    : isSigned                                 ? NumberKind::Signed
                                               : NumberKind::Unsigned;
  return ScalarTypeOf(numbers, std::int64_t(H5Tget_size(type)));
}

/// An attribute of an object in a file; its handle is invalid if there is none.
struct OpenAttribute
{
  OpenAttribute(hid_t file, const std::string& path, const std::string& name)
    : object(H5Oopen(file, path.c_str(), H5P_DEFAULT), H5Oclose)
    , attribute(object >= 0 && H5Aexists(object, name.c_str()) > 0
          ? H5Aopen(object, name.c_str(), H5P_DEFAULT)
          : hid_t(-1),
        H5Aclose)
    , type(attribute >= 0 ? H5Aget_type(attribute) : hid_t(-1), H5Tclose)
    , space(attribute >= 0 ? H5Aget_space(attribute) : hid_t(-1), H5Sclose)
  {
  }

  SilentHdf5 silentHere;
  Hdf5Handle object;
  Hdf5Handle attribute;
  Hdf5Handle type;
  Hdf5Handle space;
};

/// The numbers of an attribute or a data set.
std::vector<double> NumbersOf(hid_t space, hid_t type, const std::function<bool(double*)>& read)
{
  constexpr hssize_t Most = 4096;
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  const H5T_class_t kind = H5Tget_class(type);
  if (count < 1 || count > Most || (kind != H5T_INTEGER && kind != H5T_FLOAT))
  {
    return {};
  }
  std::vector<double> numbers(static_cast<std::size_t>(count));
  return read(numbers.data()) ? numbers : std::vector<double>();
}

/// The groups that a search for data sets is in, and what it has found.
struct Search
{
  std::string group;
  int depth = 0;
  std::vector<std::string>* found = nullptr;
};

herr_t Visit(hid_t parent, const char* name, const H5L_info_t* link, void* data)
{
  constexpr int Deepest = 32;
  constexpr std::size_t Most = 10000;
  const Search& search = *static_cast<const Search*>(data);
  // Links to other files are not followed.
  if (link->type != H5L_TYPE_HARD || search.found->size() >= Most)
  {
    return 0;
  }
  const Hdf5Handle object(H5Oopen(parent, name, H5P_DEFAULT), H5Oclose);
  const H5I_type_t kind = object >= 0 ? H5Iget_type(object) : H5I_BADID;
  Search inner = { search.group + "/" + name, search.depth + 1, search.found };
  if (kind == H5I_DATASET)
  {
    search.found->push_back(inner.group);
  }
  if (kind == H5I_GROUP && inner.depth < Deepest)
  {
    H5Literate(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, Visit, &inner);
  }
  return 0;
}

}

Hdf5File::Hdf5File(const std::string& path)
  : path(path)
  , file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose)
{
  if (this->file < 0)
  {
    ReadableFileSize(path); // says if there is no such file
    FailToRead(path, "a complete HDF5 file", "a damaged or truncated one");
  }
}

bool Hdf5File::Has(const std::string& name) const
{
  const SilentHdf5 silentHere;
  // Each group on the way must exist before the next is asked for.
  for (std::size_t end = name.find('/', 1); end != std::string::npos; end = name.find('/', end + 1))
  {
    if (H5Lexists(this->file, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0)
    {
      return false;
    }
  }
  return H5Lexists(this->file, name.c_str(), H5P_DEFAULT) > 0;
}

std::size_t Hdf5File::Count(const std::string& pattern) const
{
  constexpr std::size_t Most = 1000000;
  std::size_t count = 0;
  while (count < Most && this->Has(Numbered(pattern, count)))
  {
    ++count;
  }
  return count;
}

std::vector<std::string> Hdf5File::DataSets() const
{
  const SilentHdf5 silentHere;
  std::vector<std::string> found;
  Search search = { "", 0, &found };
  H5Literate(this->file, H5_INDEX_NAME, H5_ITER_INC, nullptr, Visit, &search);
  return found;
}

std::string Hdf5File::TextAttribute(const std::string& object, const std::string& name) const
{
  const OpenAttribute open(this->file, object, name);
  if (open.attribute < 0)
  {
    return "";
  }
  const hssize_t count = H5Sget_simple_extent_npoints(open.space);
  constexpr std::size_t Longest = 4096;
  const std::size_t length = H5Tget_size(open.type);
  const bool isText = H5Tget_class(open.type) == H5T_STRING && count > 0;
  if (isText && H5Tis_variable_str(open.type) > 0)
  {
    char* text = nullptr;
    const bool isRead = count == 1 && H5Aread(open.attribute, open.type, &text) >= 0 && text;
    const std::string copy = isRead ? text : "";
    H5free_memory(text);
    return copy;
  }
  if (!isText || length < 1 || length > Longest || std::size_t(count) > Longest / length)
  {
    return "";
  }
  std::string text(length * std::size_t(count), '\0');
  return H5Aread(open.attribute, open.type, text.data()) >= 0 ? text.substr(0, text.find('\0'))
                                                              : "";
}

std::vector<std::string> Hdf5File::TextsAttribute(
  const std::string& object, const std::string& name) const
{
  const OpenAttribute open(this->file, object, name);
  if (open.attribute < 0)
  {
    return {};
  }
  const hssize_t count = H5Sget_simple_extent_npoints(open.space);
  constexpr hssize_t Most = 4096;
  if (H5Tget_class(open.type) != H5T_STRING || H5Tis_variable_str(open.type) <= 0 || count < 1 ||
    count > Most)
  {
    return {};
  }
  std::vector<char*> texts(std::size_t(count), nullptr);
  if (H5Aread(open.attribute, open.type, texts.data()) < 0)
  {
    return {};
  }
  std::vector<std::string> copies;
  for (char* const text : texts)
  {
    copies.emplace_back(text ? text : "");
  }
  H5Dvlen_reclaim(open.type, open.space, H5P_DEFAULT, texts.data());
  return copies;
}

std::vector<std::string> Hdf5File::ScalesOf(const std::string& dataSet) const
{
  const OpenAttribute open(this->file, dataSet, "DIMENSION_LIST");
  if (open.attribute < 0)
  {
    return {};
  }
  const Hdf5Handle element(H5Tget_super(open.type), H5Tclose);
  const hssize_t count = H5Sget_simple_extent_npoints(open.space);
  const bool areReferences = H5Tget_class(open.type) == H5T_VLEN && element >= 0 &&
    H5Tequal(element, H5T_STD_REF_OBJ) > 0 && count > 0 && count <= MostHdf5Axes;
  std::vector<hvl_t> lists(areReferences ? std::size_t(count) : 0, hvl_t{ 0, nullptr });
  if (lists.empty() || H5Aread(open.attribute, open.type, lists.data()) < 0)
  {
    return {};
  }
  std::vector<std::string> scales;
  for (const hvl_t& list : lists)
  {
    const Hdf5Handle scale(
      list.len > 0 ? H5Rdereference2(open.object, H5P_DEFAULT, H5R_OBJECT, list.p) : hid_t(-1),
      H5Oclose);
    char path[256] = {};
    const bool isNamed = scale >= 0 && H5Iget_name(scale, path, sizeof(path)) > 0;
    scales.emplace_back(isNamed ? path : "");
  }
  H5Dvlen_reclaim(open.type, open.space, H5P_DEFAULT, lists.data());
  return scales;
}

std::vector<double> Hdf5File::NumberAttribute(
  const std::string& object, const std::string& name) const
{
  const OpenAttribute open(this->file, object, name);
  if (open.attribute < 0)
  {
    return {};
  }
  return NumbersOf(open.space, open.type,
    [&](double* numbers) { return H5Aread(open.attribute, H5T_NATIVE_DOUBLE, numbers) >= 0; });
}

std::vector<double> Hdf5File::Numbers(const std::string& dataSet) const
{
  const SilentHdf5 silentHere;
  const Hdf5Handle data(H5Dopen(this->file, dataSet.c_str(), H5P_DEFAULT), H5Dclose);
  if (data < 0)
  {
    return {};
  }
  const Hdf5Handle type(H5Dget_type(data), H5Tclose);
  const Hdf5Handle space(H5Dget_space(data), H5Sclose);
  return NumbersOf(space, type,
    [&](double* numbers)
    { return H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers) >= 0; });
}

namespace
{

Hdf5Handle DataSetOf(const Hdf5File& file, const std::string& name)
{
  const hid_t data = H5Dopen(file, name.c_str(), H5P_DEFAULT);
  if (data < 0)
  {
    FailToRead(file.Path(), "the data set " + Quoted(name, 80), "none, or a damaged one");
  }
  return { data, H5Dclose };
}

}

Hdf5Layout LayoutOf(const Hdf5File& file, const std::string& dataSet)
{
  const SilentHdf5 silent;
  const Hdf5Handle data = DataSetOf(file, dataSet);
  const Hdf5Handle space(H5Dget_space(data), H5Sclose);
  const Hdf5Handle type(H5Dget_type(data), H5Tclose);
  const Hdf5Handle creation(H5Dget_create_plist(data), H5Pclose);
  Hdf5Layout layout;
  layout.size = SizeOfSpace(space);
  layout.scalarType = ScalarTypeOf(MemoryTypeOf(type));
  layout.storedBytes = double(H5Dget_storage_size(data));
  const bool hasChunks = H5Pget_layout(creation) == H5D_CHUNKED;
  // Chunks that were never written are not in the file.
  layout.isCompressed = hasChunks;
  layout.neededBytes = double(H5Tget_size(type)) * double(H5Sget_simple_extent_npoints(space));
  std::vector<hsize_t> chunk(layout.size.size(), 1);
  if (hasChunks && !chunk.empty())
  {
    H5Pget_chunk(creation, int(chunk.size()), chunk.data());
  }
  layout.chunk.assign(chunk.begin(), chunk.end());
  if (!hasChunks)
  {
    // Any box can be read of other data sets, so a slice is enough.
    const std::size_t lines = layout.size.size() - std::min<std::size_t>(layout.size.size(), 2);
    std::copy(layout.size.begin() + lines, layout.size.end(), layout.chunk.begin() + lines);
  }
  return layout;
}

Hdf5Chunks ChunksOf(const Hdf5File& file, const std::string& dataSet,
  const std::vector<std::vector<std::int64_t>>& starts)
{
  const SilentHdf5 silent;
  const Hdf5Handle data = DataSetOf(file, dataSet);
  const Hdf5Handle creation(H5Dget_create_plist(data), H5Pclose);
  const Hdf5Handle stored(H5Dget_type(data), H5Tclose);
  const Hdf5Handle type = MemoryTypeOf(stored);
  Hdf5Chunks chunks;
  chunks.fill.resize(std::max(H5Tget_size(type), sizeof(std::uint64_t)));
  H5D_fill_time_t fillTime = H5D_FILL_TIME_NEVER;
  H5D_fill_value_t kind = H5D_FILL_VALUE_UNDEFINED;
  const bool isFilled = H5Pget_layout(creation) == H5D_CHUNKED &&
    H5Pget_fill_time(creation, &fillTime) >= 0 && fillTime != H5D_FILL_TIME_NEVER &&
    H5Pfill_value_defined(creation, &kind) >= 0 && kind != H5D_FILL_VALUE_UNDEFINED &&
    H5Pget_fill_value(creation, type, chunks.fill.data()) >= 0;
  bool areAllThere = true;
  for (std::size_t i = 0; isFilled && i < starts.size(); ++i)
  {
    const std::vector<hsize_t> start(starts[i].begin(), starts[i].end());
    unsigned filters = 0;
    haddr_t address = HADDR_UNDEF;
    hsize_t bytes = 0;
    // A chunk that cannot be found out about is read, so that its reader says why.
    const bool isThere =
      H5Dget_chunk_info_by_coord(data, start.data(), &filters, &address, &bytes) < 0 ||
      address != HADDR_UNDEF;
    chunks.areThere.push_back(isThere ? 1 : 0);
    areAllThere = areAllThere && isThere;
  }
  if (areAllThere)
  {
    chunks.areThere.clear();
  }
  return chunks;
}

void ReadHdf5Box(const Hdf5File& file, const std::string& dataSet,
  const std::vector<std::int64_t>& start, const std::vector<std::int64_t>& count, void* values)
{
  const SilentHdf5 silent;
  const Hdf5Handle data(H5Dopen(file, dataSet.c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Handle space(data >= 0 ? H5Dget_space(data) : -1, H5Sclose);
  const Hdf5Handle stored(data >= 0 ? H5Dget_type(data) : -1, H5Tclose);
  const Hdf5Handle type = MemoryTypeOf(stored);
  const std::vector<hsize_t> from(start.begin(), start.end());
  const std::vector<hsize_t> length(count.begin(), count.end());
  const Hdf5Handle memory(H5Screate_simple(int(length.size()), length.data(), nullptr), H5Sclose);
  const bool isRead = space >= 0 && type >= 0 &&
    H5Sselect_hyperslab(space, H5S_SELECT_SET, from.data(), nullptr, length.data(), nullptr) >= 0 &&
    H5Dread(data, type, memory, space, H5P_DEFAULT, values) >= 0;
  if (!isRead)
  {
    FailToRead(file.Path(), "readable values of " + Quoted(dataSet, 80),
      "damaged ones, or a compression that the library HDF5 does not know");
  }
}

}
