"""Prints what pydicom finds in a DICOM structured report of measurements, as a line of JSON."""

import json
import sys

import pydicom

report = pydicom.dcmread(sys.argv[1])


def name_of(item):
    return item.ConceptNameCodeSequence[0].CodeMeaning


def children(item, value_type):
    return [child for child in item.get("ContentSequence", []) if child.ValueType == value_type]


def child_named(item, name):
    named = [child for child in item.ContentSequence if child.get("ConceptNameCodeSequence")]
    return next(child for child in named if name_of(child) == name)


def number(item):
    measured = item.MeasuredValueSequence[0]
    derivation = [c.ConceptCodeSequence[0].CodeMeaning for c in children(item, "CODE")]
    return {
        "name": "/".join([name_of(item), *derivation]),
        "value": float(measured.NumericValue),
        "unit": measured.MeasurementUnitsCodeSequence[0].CodeValue,
    }


def group(item):
    places = children(item, "SCOORD3D")
    return {
        "id": child_named(item, "Tracking Identifier").TextValue,
        "comments": [c.TextValue for c in children(item, "TEXT") if name_of(c) == "Comment"],
        "numbers": [number(child) for child in children(item, "NUM")],
        "types": [place.GraphicType for place in places],
        "points": [[float(x) for x in place.GraphicData] for place in places],
        "frames": sorted({place.ReferencedFrameOfReferenceUID for place in places}),
    }


measurements = child_named(report, "Imaging Measurements")
evidence = report.CurrentRequestedProcedureEvidenceSequence[0]
images = child_named(child_named(report, "Image Library"), "Image Library Group")
print(
    json.dumps(
        {
            "class": report.SOPClassUID.name,
            "modality": report.Modality,
            "title": name_of(report),
            "template": report.ContentTemplateSequence[0].TemplateIdentifier,
            "patient": str(report.PatientName),
            "study": report.StudyInstanceUID,
            "evidence": sum(
                len(series.ReferencedSOPSequence) for series in evidence.ReferencedSeriesSequence
            ),
            "images": [
                child.ReferencedSOPSequence[0].ReferencedSOPInstanceUID
                for child in children(images, "IMAGE")
            ],
            "groups": [group(item) for item in measurements.ContentSequence],
        }
    )
)
