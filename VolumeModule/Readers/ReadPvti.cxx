// Parallel VTK image data: an XML file that names the files of the pieces, each a VTI file.
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/VoxelLayout.h"
#include "Readers/VtkImage.h"
#include "Readers/VtkMessages.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>

namespace varimarch
{
namespace
{

using Extent = std::array<int, 6>;

/// The names of the pieces' files, relative to the folder of the file itself.
std::vector<std::string> PiecesOf(const std::string& path)
{
  VtkMessages messages;
  vtkNew<vtkXMLDataParser> parser;
  messages.Observe(parser);
  parser->SetFileName(path.c_str());
  const bool isParsed = parser->Parse() != 0;
  vtkXMLDataElement* root = parser->GetRootElement();
  vtkXMLDataElement* image =
    isParsed && root ? root->FindNestedElementWithName("PImageData") : nullptr;
  std::vector<std::string> pieces;
  for (int i = 0; image && i < image->GetNumberOfNestedElements(); ++i)
  {
    const char* source = image->GetNestedElement(i)->GetAttribute("Source");
    if (source)
    {
      pieces.push_back((std::filesystem::path(path).parent_path() / source).string());
    }
  }
  if (pieces.empty())
  {
    FailToRead(path, "parallel VTK image data with pieces", messages.FirstErrorOr("none"));
  }
  return pieces;
}

/// The smallest box with all pieces.
Extent CommonExtent(const std::vector<vtkSmartPointer<vtkImageData>>& pieces)
{
  Extent common;
  pieces.front()->GetExtent(common.data());
  for (vtkImageData* piece : pieces)
  {
    for (std::size_t side = 0; side < 6; ++side)
    {
      const int index = piece->GetExtent()[side];
      common[side] = side % 2 == 0 ? std::min(common[side], index) : std::max(common[side], index);
    }
  }
  return common;
}

/// Copies a piece, row by row, to its place.
void CopyPiece(vtkImageData* piece, vtkImageData* whole)
{
  const int* extent = piece->GetExtent();
  const std::size_t rowBytes = std::size_t(extent[1] - extent[0] + 1) *
    std::size_t(piece->GetNumberOfScalarComponents()) * std::size_t(piece->GetScalarSize());
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      std::memcpy(whole->GetScalarPointer(extent[0], j, k),
        piece->GetScalarPointer(extent[0], j, k), rowBytes);
    }
  }
}

/// Fails if the pieces do not fill the box, or differ in type.
void CheckPieces(const std::string& path, const Extent& box,
  const std::vector<vtkSmartPointer<vtkImageData>>& pieces)
{
  double pointCount = 0.0;
  for (vtkImageData* piece : pieces)
  {
    pointCount += double(piece->GetNumberOfPoints());
    if (piece->GetScalarType() != pieces.front()->GetScalarType() ||
      piece->GetNumberOfScalarComponents() != pieces.front()->GetNumberOfScalarComponents())
    {
      FailToRead(path, "pieces of one type", "different ones");
    }
  }
  const double wholeCount =
    double(box[1] - box[0] + 1) * double(box[3] - box[2] + 1) * double(box[5] - box[4] + 1);
  if (pointCount < wholeCount)
  {
    FailToRead(path, "pieces that fill a box", "gaps between them");
  }
}

}

Volume ReadPvti(const std::string& path, const ReadOptions&, ReadProgress& progress)
{
  const std::vector<std::string> files = PiecesOf(path);
  std::vector<vtkSmartPointer<vtkImageData>> pieces;
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    ReadProgress part =
      progress.Part(double(i) / double(files.size()), double(i + 1) / double(files.size()));
    ReadableFileSize(files[i]);
    pieces.push_back(ReadVtiFile(files[i], part));
  }
  const Extent box = CommonExtent(pieces);
  CheckPieces(path, box, pieces);
  vtkImageData* first = pieces.front();
  CheckedByteCount(path,
    { { box[1] - box[0] + 1, box[3] - box[2] + 1, box[5] - box[4] + 1 }, first->GetScalarType(),
      first->GetNumberOfScalarComponents() });
  vtkNew<vtkImageData> whole;
  whole->SetExtent(const_cast<int*>(box.data()));
  whole->SetOrigin(first->GetOrigin());
  whole->SetSpacing(first->GetSpacing());
  whole->SetDirectionMatrix(first->GetDirectionMatrix());
  whole->AllocateScalars(first->GetScalarType(), first->GetNumberOfScalarComponents());
  whole->GetPointData()->GetScalars()->SetName(first->GetPointData()->GetScalars()->GetName());
  for (vtkImageData* piece : pieces)
  {
    CopyPiece(piece, whole);
  }
  return VolumeOf(path, whole);
}

}
