#ifndef Varimarch_Readers_Decoder_Fields_h
#define Varimarch_Readers_Decoder_Fields_h

#include "Readers/Decoder/Wire.h"
#include "Readers/Dicom/FileFrames.h"
#include "Readers/Dicom/Metadata.h"
#include "Readers/Packed/Unpacking.h"
#include "Readers/Pyramids/VoxelPyramid.h"
#include "Readers/VolumeFile.h"
#include "Readers/VoxelLayout.h"

// The members of the structs that the messages between a reader and its decoder hold.

namespace glm
{

template <class Wire>
void Fields(Wire& wire, dvec2& vector)
{
  wire(vector.x, vector.y);
}

template <class Wire>
void Fields(Wire& wire, ivec2& vector)
{
  wire(vector.x, vector.y);
}

template <class Wire>
void Fields(Wire& wire, dvec3& vector)
{
  wire(vector.x, vector.y, vector.z);
}

template <class Wire>
void Fields(Wire& wire, dmat3& matrix)
{
  wire(matrix[0], matrix[1], matrix[2]);
}

template <class Wire>
void Fields(Wire& wire, dmat2x3& matrix)
{
  wire(matrix[0], matrix[1]);
}

}

namespace varimarch
{

template <class Wire>
void Fields(Wire& wire, RawOptions& raw)
{
  wire(raw.dimensions, raw.scalarType, raw.componentCount, raw.spacingMm, raw.headerBytes,
    raw.bigEndian);
}

template <class Wire>
void Fields(Wire& wire, ReadOptions& options)
{
  wire(options.raw, options.series, options.kind, options.rectify, options.level, options.time,
    options.channel);
}

template <class Wire>
void Fields(Wire& wire, WindowLevel& range)
{
  wire(range.window, range.level);
}

template <class Wire>
void Fields(Wire& wire, LabelledSegment& segment)
{
  wire(segment.value, segment.name, segment.rgb);
}

template <class Wire>
void Fields(Wire& wire, VolumeChannel& channel)
{
  wire(channel.name, channel.rgb);
}

template <class Wire>
void Fields(Wire& wire, VolumeTimes& times)
{
  wire(times.values, times.areSeconds);
}

/// All but the image.
template <class Wire>
void Fields(Wire& wire, Volume& volume)
{
  wire(volume.modality, volume.bodyPart, volume.hasContrastAgent, volume.weighting,
    volume.windowLevel, volume.lowestInside, volume.isInverted, volume.warnings,
    volume.irregularSlicesMm, volume.isMisplaced, volume.isRectified, volume.segments,
    volume.uptakeValueFactor, volume.frameOfReference, volume.times, volume.showsPatient,
    volume.holdsColors, volume.channels, volume.kinds);
}

template <class Wire>
void Fields(Wire& wire, VoxelLayout& layout)
{
  wire(layout.dimensions, layout.scalarType, layout.componentCount);
}

template <class Wire>
void Fields(Wire& wire, ImageGeometry& geometry)
{
  wire(geometry.originMm, geometry.axesMm);
}

template <class Wire>
void Fields(Wire& wire, BrickSource::Level& level)
{
  wire(level.dimensions, level.chunk, level.scale);
}

template <class Wire>
void Fields(Wire& wire, BrickSource::Box& box)
{
  wire(box.lower, box.upper);
}

template <class Wire>
void Fields(Wire& wire, PyramidOrder& order)
{
  wire(order.format, order.path, order.options);
}

template <class Wire>
void Fields(Wire& wire, PyramidForm& form)
{
  wire(form.levels, form.geometries, form.scalarType, form.windowLevel, form.warnings, form.times,
    form.channels, form.otherChannels);
}

template <class Wire>
void Fields(Wire& wire, StoredChunks& chunks)
{
  wire(chunks.areThere, chunks.fill, chunks.stamp);
}

template <class Wire>
void Fields(Wire& wire, UnpackingOrder& order)
{
  wire(order.path, order.folder, order.spaceBytes);
}

template <class Wire>
void Fields(Wire& wire, UnpackedContent& content)
{
  wire(content.path, content.warnings);
}

template <class Wire>
void Fields(Wire& wire, DicomFault& fault)
{
  wire(fault.path, fault.expected, fault.found, fault.seriesUid);
}

template <class Wire, class Entry>
void Fields(Wire& wire, DicomTable<Entry>& table)
{
  wire(table.first, table.entries);
}

template <class Wire>
void Fields(Wire& wire, DicomFile& file)
{
  wire(file.path, file.isDeflated, file.transferSyntax, file.seriesUid, file.instanceUid,
    file.seriesDescription, file.frameOfReference, file.modality, file.isSegmentation,
    file.seriesNumber, file.rows, file.columns, file.frameCount, file.isTruncated, file.samples,
    file.bitsAllocated, file.bitsStored, file.highBit, file.hasSwappedBytes, file.isSigned,
    file.isFloat, file.colours, file.palette);
}

/// All but the file and the table.
template <class Wire>
void Fields(Wire& wire, DicomFrame& frame)
{
  wire(frame.number, frame.firstPixel, frame.size, frame.positionMm, frame.axes, frame.pixelMm,
    frame.pixelAspect, frame.distanceMm, frame.isDistanceThickness, frame.heightMm,
    frame.sharesPlace, frame.isPatientSpace, frame.instanceNumber, frame.differences,
    frame.timeSeconds, frame.slope, frame.intercept, frame.isRealWorld, frame.otherMap,
    frame.padding, frame.isLossy);
}

template <class Wire>
void Fields(Wire& wire, DicomMetadata& metadata)
{
  wire(metadata.modality, metadata.bodyPart, metadata.hasContrastAgent, metadata.weighting,
    metadata.windowLevel, metadata.isInverted, metadata.uptakeValueFactor, metadata.uptakeDoubt);
}

template <class Wire>
void Fields(Wire& wire, DicomRecord& record)
{
  wire(record.patientName, record.patientId, record.studyUid, record.studyDate,
    record.studyDescription, record.seriesUid, record.seriesNumber, record.seriesDescription,
    record.modality, record.imageUid);
}

template <class Wire>
void Fields(Wire& wire, DicomTag& tag)
{
  wire(tag.depth, tag.tag, tag.representation, tag.name, tag.value);
}

}

#endif
