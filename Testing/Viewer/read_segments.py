"""Prints what pydicom finds in a DICOM segmentation, as a line of JSON."""

import json
import sys

import pydicom

segmentation = pydicom.dcmread(sys.argv[1])
frames = segmentation.pixel_array.reshape(-1, segmentation.Rows, segmentation.Columns)
per_frame = segmentation.PerFrameFunctionalGroupsSequence
reference = segmentation.ReferencedSeriesSequence[0]
print(
    json.dumps(
        {
            "class": segmentation.SOPClassUID.name,
            "patient": str(segmentation.PatientName),
            "study": segmentation.StudyInstanceUID,
            "frame of reference": segmentation.FrameOfReferenceUID,
            "series": reference.SeriesInstanceUID,
            "images": len(reference.ReferencedInstanceSequence),
            "labels": [segment.SegmentLabel for segment in segmentation.SegmentSequence],
            "segments": [
                group.SegmentIdentificationSequence[0].ReferencedSegmentNumber for group in per_frame
            ],
            "z": [
                float(group.PlanePositionSequence[0].ImagePositionPatient[2]) for group in per_frame
            ],
            "voxels": [int(frame.sum()) for frame in frames],
        }
    )
)
