#ifndef Varimarch_Testing_Fuzz_VolumeSeeds_h
#define Varimarch_Testing_Fuzz_VolumeSeeds_h

#include <string>
#include <vector>

namespace varimarch
{

/// Small inputs of each volume format, made of the tests' phantoms.
std::vector<std::string> NrrdSeeds();
std::vector<std::string> MetaImageSeeds();
std::vector<std::string> NiftiSeeds();
std::vector<std::string> AnalyzeSeeds();
std::vector<std::string> VtiSeeds();
std::vector<std::string> PvtiSeeds();
std::vector<std::string> LegacyVtkSeeds();
std::vector<std::string> Inv3Seeds();
std::vector<std::string> TiffSeeds();
std::vector<std::string> PictureStackSeeds();
std::vector<std::string> NpySeeds();
std::vector<std::string> MghSeeds();
std::vector<std::string> MincSeeds();
std::vector<std::string> AfniSeeds();
std::vector<std::string> MifSeeds();
std::vector<std::string> ParRecSeeds();
std::vector<std::string> GiplSeeds();
std::vector<std::string> MrcSeeds();
std::vector<std::string> SlcSeeds();
std::vector<std::string> PvmSeeds();
std::vector<std::string> ArchiveSeeds();
std::vector<std::string> ZarrSeeds();
std::vector<std::string> Hdf5Seeds();
std::vector<std::string> BigDataViewerSeeds();

}

#endif
