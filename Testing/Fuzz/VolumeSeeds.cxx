#include "Fuzz/VolumeSeeds.h"

#include "Fuzz/FuzzInput.h"
#include "Module/Files/GoodFiles.h"
#include "Module/Files/PhantomFormats.h"

#include <vtkType.h>

namespace varimarch
{

namespace
{

StoredVolume Phantom()
{
  return phantom::Stored(0);
}

StoredVolume PhantomOf(int scalarType)
{
  StoredVolume volume = Phantom();
  volume.scalarType = scalarType;
  return volume;
}

}

std::vector<std::string> NrrdSeeds()
{
  const StoredVolume volume = Phantom();
  const std::string header = NrrdHeaderText(volume);
  const std::string voxels = VoxelBytes(volume);
  return { header + "endian: little\nencoding: raw\n\n" + voxels,
    header + "endian: little\nencoding: gzip\n\n" + Gzipped(voxels),
    header + "encoding: ascii\n\n" + VoxelText(volume),
    JoinedFiles({ header + "endian: big\nencoding: raw\ndata file: b\nbyte skip: -1\n",
      VoxelBytes(volume, true) }),
    JoinedFiles({ header + "endian: little\nencoding: raw\ndata file: LIST 2\nb\nb\nb\n", voxels }),
    "NRRD0001\ntype: float\ndimension: 4\nsizes: 3 2 2 2\nkinds: vector domain domain domain\n"
    "spacings: nan 1 2 3\ncenterings: none cell node cell\nlabels: \"c\" \"x\" \"y\" \"z\"\n"
    "encoding: hex\nline skip: 1\n\nskipped\n" +
      std::string(192, 'a') };
}

std::vector<std::string> MetaImageSeeds()
{
  const StoredVolume volume = Phantom();
  const std::string header = MetaImageHeaderText(volume);
  return { header + "ElementDataFile = LOCAL\n" + VoxelBytes(volume),
    header + "CompressedData = True\nElementDataFile = LOCAL\n" + Zlibbed(VoxelBytes(volume)),
    JoinedFiles({ header + "HeaderSize = -1\nElementDataFile = b\n", VoxelBytes(volume) }),
    JoinedFiles(
      { header + "ElementDataFile = LIST 2\nb\nb\nb\n", VoxelBytes(volume).substr(0, 40) }),
    "ObjectType = Image\nNDims = 3\nBinaryData = False\nBinaryDataByteOrderMSB = True\n"
    "DimSize = 2 2 2\nElementNumberOfChannels = 2\nElementType = MET_FLOAT\n"
    "AnatomicalOrientation = RAI\nElementDataFile = LOCAL\n1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7\n" };
}

std::vector<std::string> NiftiSeeds()
{
  const StoredVolume volume = Phantom();
  return { NiftiBytes(volume), NiftiBytes(volume, NiftiForm::Quaternion, true),
    Gzipped(NiftiBytes(PhantomOf(VTK_FLOAT))), Nifti2Bytes(volume), Nifti2Bytes(volume, true) };
}

std::vector<std::string> AnalyzeSeeds()
{
  const StoredVolume volume = Phantom();
  return { JoinedFiles({ AnalyzeHeaderBytes(volume), VoxelBytes(volume) }),
    JoinedFiles({ AnalyzeHeaderBytes(volume, { 2, 2, 2 }, true), VoxelBytes(volume, true),
      SpmMatrixBytes(volume) }) };
}

std::vector<std::string> NpySeeds()
{
  return { NpyBytes(Phantom(), { 3, 4, 5 }), NpyBytes(PhantomOf(VTK_FLOAT), { 5, 4, 3 }, true),
    NpyBytes(PhantomOf(VTK_DOUBLE), { 3, 4, 5, 1 }, false, true) };
}

std::vector<std::string> MghSeeds()
{
  return { MghBytes(Phantom()), MghBytes(PhantomOf(VTK_FLOAT)), Gzipped(MghBytes(Phantom())) };
}

std::vector<std::string> AfniSeeds()
{
  const StoredVolume volume = Phantom();
  return { JoinedFiles({ AfniHeaderText(volume), VoxelBytes(volume) }),
    JoinedFiles({ AfniHeaderText(volume, true), Gzipped(VoxelBytes(volume, true)) }) };
}

std::vector<std::string> MifSeeds()
{
  const StoredVolume volume = Phantom();
  const std::string header = MifHeaderText(volume, { 2, 0, 1 }, { true, false, true });
  const std::string detached =
    "mrtrix image\ndim: 5,4,3\nvox: 1,1,nan\nlayout: -0,+1,+2\ndatatype: Int16BE\n"
    "scaling: 1,2\ncomments: none\nfile: b 0\nEND\n";
  return { header + VoxelBytes(volume), JoinedFiles({ detached, VoxelBytes(volume) }) };
}

std::vector<std::string> ParRecSeeds()
{
  const StoredVolume volume = Phantom();
  return { JoinedFiles({ ParText(volume, { 0, 1, 2 }), VoxelBytes(volume) }),
    JoinedFiles({ ParText(volume, { 2, 0, 1 }), VoxelBytes(volume) }) };
}

std::vector<std::string> GiplSeeds()
{
  return { GiplBytes(Phantom()), GiplBytes(PhantomOf(VTK_FLOAT)), Gzipped(GiplBytes(Phantom())) };
}

std::vector<std::string> MrcSeeds()
{
  return { MrcBytes(Phantom()), MrcBytes(PhantomOf(VTK_FLOAT), true) };
}

std::vector<std::string> SlcSeeds()
{
  return { SlcBytes(PhantomOfBytes(), false), SlcBytes(PhantomOfBytes(), true) };
}

std::vector<std::string> PvmSeeds()
{
  return { PvmBytes(PhantomOfBytes()), PvmBytes(Phantom()),
    DdsBytes(PvmBytes(PhantomOfBytes()), 1, 5), DdsBytes(PvmBytes(Phantom()), 2, 10) };
}

}
