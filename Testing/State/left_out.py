"""Methods that change an object but no picture that a mapper draws, and why they are left out."""

# For each reason the names of methods, some of them of one object only, with "_" for blanks.
LEFT_OUT = {
    "observers and debugging": """
        AddObserver RemoveObserver RemoveObservers RemoveAllObservers DebugOn DebugOff SetDebug
        GlobalWarningDisplayOn GlobalWarningDisplayOff SetGlobalWarningDisplay AddConsumer
        RemoveConsumer""",
    "memory and reference counts": """
        SetReferenceCount SetMemkindDirectory GlobalReleaseDataFlagOn GlobalReleaseDataFlagOff
        SetGlobalReleaseDataFlag ReleaseDataFlagOn ReleaseDataFlagOff SetReleaseDataFlag""",
    "keys of pipelines, without a meaning for renderers": """
        SetInformation SetPropertyKeys RemoveNamedFieldInformation SetActiveAttribute
        SetActiveAttributeInfo SetFieldData SetPointDataActiveScalarInfo SetAxisUpdateExtent
        SetNumberOfScalarComponents SetScalarType SetExecutive SetDefaultExecutivePrototype
        SetProgressObserver SetProgressShiftScale SetProgressText SetProgress SetAbortExecute
        AbortExecuteOn AbortExecuteOff""",
    "inputs of mappers, which SetInputData and SetInputConnection replace": """
        AddInputConnection AddInputDataObject RemoveAllInputConnections RemoveAllInputs
        RemoveInputConnection SetInputArrayToProcess""",
    "copies that share everything, or that VTK's renderers do not expect in one that draws": """
        ShallowCopy DeepCopy AllocateScalars
        AllocateCellGhostArray AllocatePointGhostArray SetCellOrderAndRationalWeights""",
    "pointers, which Python does not have": """
        FillFromDataPointer SetAnnotations""",
    "lists of labels and values that are not numbers": """
        SetAnnotation RemoveAnnotation SetNanColorRGBA""",
    "what VTK's renderers draw beside volumes": """
        AddActor2D RemoveActor2D AddViewProp RemoveViewProp RemoveAllViewProps AddVolume
        RemoveVolume AddCuller RemoveCuller SetBackgroundTexture SetLeftBackgroundTexture
        SetRightBackgroundTexture SetEnvironmentTexture SetDelegate SetGL2PSSpecialPropCollection
        SetLightCollection SetPass SetRenderWindow SetUserLightTransform SetFXAAOptions
        ZoomToBoxUsingViewAngle""",
    "what crashes VTK's camera without a matrix, with which own.py tries it": """
        SetUseExplicitProjectionTransformMatrix UseExplicitProjectionTransformMatrixOn
        UseExplicitProjectionTransformMatrixOff""",
    "scenes of several volumes that VTK's own mapper has to draw, and may leave black": """
        other_opacity.SetUseLogScale other_opacity.UseLogScaleOn other_opacity.UseLogScaleOff""",
    "eyes and scissors of headsets and of selections": """
        SetEyePosition SetEyeTransformMatrix SetScissorRect SetUseScissor""",
    "what keeps pixels of the picture before": """
        DrawOn DrawOff SetDraw EraseOn EraseOff SetErase PreserveColorBufferOn
        PreserveColorBufferOff SetPreserveColorBuffer""",
    "times and paths of props, which a renderer sets itself": """
        AddEstimatedRenderTime SetEstimatedRenderTime SetAllocatedRenderTime BuildPaths""",
}


def left_out(target, name):
    """The reason why a method is left out; nothing if it is not."""
    for reason, names in LEFT_OUT.items():
        if name in names.split() or f"{target}.{name}".replace(" ", "_") in names.split():
            return reason
    return None
