#ifndef Varimarch_Readers_Pyramids_Hdf5File_h
#define Varimarch_Readers_Pyramids_Hdf5File_h

#include "Readers/Parsing/Hdf5Handles.h"

#include <cstdint>
#include <string>
#include <vector>

namespace varimarch
{

/// An open file of HDF5.
class Hdf5File
{
public:
  /// @throws std::runtime_error if it is damaged
  explicit Hdf5File(const std::string& path);

  const std::string& Path() const { return this->path; }
  operator hid_t() const { return this->file; }

  bool Has(const std::string& name) const;

  /// The number of groups or data sets that have a name with 0, 1, 2 and so on in place of "%".
  std::size_t Count(const std::string& pattern) const;

  /// The names of the data sets of numbers in all groups. Groups that are nested deeper than 32 are
  /// left out.
  std::vector<std::string> DataSets() const;

  /// An attribute that is a text, also one in single letters, as Imaris writes them; empty if there
  /// is none.
  std::string TextAttribute(const std::string& object, const std::string& name) const;

  /// An attribute of at most 4096 texts of any length; empty if there is none.
  std::vector<std::string> TextsAttribute(const std::string& object, const std::string& name) const;

  /// The data sets that are the scales of a data set's axes, as netCDF-4 writes them; empty texts
  /// for axes without one.
  std::vector<std::string> ScalesOf(const std::string& dataSet) const;

  /// An attribute, or a data set, of at most 4096 numbers; empty if there is none.
  std::vector<double> NumberAttribute(const std::string& object, const std::string& name) const;
  std::vector<double> Numbers(const std::string& dataSet) const;

private:
  std::string path;
  SilentHdf5 silent;
  Hdf5Handle file;
};

/// The size, chunks and type of a data set.
struct Hdf5Layout
{
  std::vector<std::int64_t> size;  ///< slowest first
  std::vector<std::int64_t> chunk; ///< a slice if the data set is in one piece
  int scalarType = 0;              ///< a VTK type; VTK_VOID for values that are no numbers
  double storedBytes = 0.0;        ///< bytes in the file
  double neededBytes = 0.0;        ///< bytes that all values need there without compression
  bool isCompressed = false;       ///< True if the file may hold less bytes than the values need.
};

/// @throws std::runtime_error if there is no such data set
Hdf5Layout LayoutOf(const Hdf5File& file, const std::string& dataSet);

/// The chunks of a data set that its file has.
struct Hdf5Chunks
{
  std::vector<std::uint8_t> areThere; ///< 1 for each that is there, 0 for others; empty if all are
  std::vector<char> fill;             ///< the value of the others, in the machine's byte order
};

/// Looks for the chunks that begin at some places.
/// @param starts  the first index of each chunk along each axis, slowest first
/// @throws std::runtime_error if there is no such data set
Hdf5Chunks ChunksOf(const Hdf5File& file, const std::string& dataSet,
  const std::vector<std::vector<std::int64_t>>& starts);

/// Reads a box of values of at most 16 axes, in the machine's byte order.
/// @param start  the first index along each axis, slowest first
/// @param count  the length along each axis
/// @throws std::runtime_error if the values cannot be read
void ReadHdf5Box(const Hdf5File& file, const std::string& dataSet,
  const std::vector<std::int64_t>& start, const std::vector<std::int64_t>& count, void* values);

}

#endif
