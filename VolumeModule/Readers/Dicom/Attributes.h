#ifndef Varimarch_Readers_Dicom_Attributes_h
#define Varimarch_Readers_Dicom_Attributes_h

#include <vtkDICOMMetaData.h>
#include <vtkDICOMTagPath.h>
#include <vtkDICOMValue.h>

#include <cmath>
#include <optional>
#include <string>

namespace varimarch
{

/// The attributes of one frame of a file: its own, else those that the frames share, else those of
/// the file. An attribute that is empty or not a number counts as missing.
class DicomAttributes
{
public:
  /// @param meta  the attributes of a single file; must outlive this object
  explicit DicomAttributes(vtkDICOMMetaData* meta, int frame = 0)
    : meta(meta)
    , frame(frame)
  {
  }

  template <class Tag>
  const vtkDICOMValue& Value(const Tag& tag) const
  {
    return this->meta->Get(0, this->frame, tag);
  }

  /// The value as text, several joined by backslashes; empty if missing.
  template <class Tag>
  std::string Text(const Tag& tag) const
  {
    const vtkDICOMValue& value = this->Value(tag);
    return value.IsValid() ? value.AsString() : std::string();
  }

  /// The first of one or more numbers.
  template <class Tag>
  std::optional<double> Number(const Tag& tag) const
  {
    const vtkDICOMValue& value = this->Value(tag);
    const bool isGiven = value.IsValid() && value.GetVL() > 0 && value.GetNumberOfValues() > 0;
    const double number = isGiven ? value.GetDouble(0) : NAN;
    return std::isfinite(number) ? std::optional<double>(number) : std::nullopt;
  }

  double NumberOr(vtkDICOMTag tag, double otherwise) const
  {
    return this->Number(tag).value_or(otherwise);
  }

  /// Vector whose components are exactly the attribute's numbers.
  template <class Vector, class Tag>
  std::optional<Vector> Numbers(const Tag& tag) const
  {
    Vector numbers;
    constexpr std::size_t Count = sizeof(Vector) / sizeof(double);
    const vtkDICOMValue& value = this->Value(tag);
    if (!value.IsValid() || value.GetNumberOfValues() != Count)
    {
      return std::nullopt;
    }
    for (std::size_t i = 0; i < Count; ++i)
    {
      const double number = value.GetDouble(i);
      if (!std::isfinite(number))
      {
        return std::nullopt;
      }
      reinterpret_cast<double*>(&numbers)[i] = number;
    }
    return numbers;
  }

private:
  vtkDICOMMetaData* meta;
  int frame;
};

}

#endif
