#ifndef DicomTags_h
#define DicomTags_h

#include <cstdint>

/// The attributes that tests of DICOM write: group and element, as in part 6 of the standard.
namespace dicom_tags
{

inline constexpr std::uint32_t Modality = 0x00080060;
inline constexpr std::uint32_t SliceThickness = 0x00180050;
inline constexpr std::uint32_t SlicesMm = 0x00180088;
inline constexpr std::uint32_t FrameTime = 0x00181063;
inline constexpr std::uint32_t AcquisitionNumber = 0x00200012;
inline constexpr std::uint32_t InstanceNumber = 0x00200013;
inline constexpr std::uint32_t Position = 0x00200032;
inline constexpr std::uint32_t Orientation = 0x00200037;
inline constexpr std::uint32_t TimePoint = 0x00200100;
inline constexpr std::uint32_t SliceLocation = 0x00201041;
inline constexpr std::uint32_t Samples = 0x00280002;
inline constexpr std::uint32_t Colours = 0x00280004;
inline constexpr std::uint32_t Frames = 0x00280008;
inline constexpr std::uint32_t Rows = 0x00280010;
inline constexpr std::uint32_t PixelSpacing = 0x00280030;
inline constexpr std::uint32_t BitsAllocated = 0x00280100;
inline constexpr std::uint32_t BitsStored = 0x00280101;
inline constexpr std::uint32_t HighBit = 0x00280102;
inline constexpr std::uint32_t PixelRepresentation = 0x00280103;
inline constexpr std::uint32_t Padding = 0x00280120;
inline constexpr std::uint32_t Intercept = 0x00281052;
inline constexpr std::uint32_t Slope = 0x00281053;
inline constexpr std::uint32_t ModalityTable = 0x00283000;
inline constexpr std::uint32_t PresentationShape = 0x20500020;
inline constexpr std::uint32_t SharedGroups = 0x52009229;
inline constexpr std::uint32_t FrameGroups = 0x52009230;
inline constexpr std::uint32_t PixelData = 0x7fe00010;

}

#endif
