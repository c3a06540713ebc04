# SPDX-License-Identifier: LGPL-2.1-or-later
"""What differs between FreeCAD 0.20, 1.0 and 1.1, in one place.

FreeCAD moved its machining modules, replaced its tool bits and its post processors. The rest of millcorr asks
here and never for a version. Jobs and operations are recognised by their properties, because a document made
by FreeCAD 0.20 opens in 1.x with dead proxies.
"""

from __future__ import annotations

import contextlib
import importlib
import importlib.util
import pathlib
import tempfile
from types import ModuleType
from typing import Any

import FreeCAD
import Part
import Path

from millcorr.errors import InputError
from millcorr.messages import mm, phrase

DocumentObject = Any
"""A FreeCAD document object; FreeCAD has no type stubs."""


def _first(*names: str) -> ModuleType:
    """First of several modules that this FreeCAD has."""
    for name in names[:-1]:
        try:
            return importlib.import_module(name)
        except ModuleNotFoundError as error:
            if not name.startswith(error.name or ""):
                raise
    return importlib.import_module(names[-1])


def job_module() -> ModuleType:
    """The module with ``Create`` for jobs."""
    return _first("Path.Main.Job", "PathScripts.PathJob")


def profile_module() -> ModuleType:
    """The module with ``Create`` for Profile operations."""
    return _first("Path.Op.Profile", "PathScripts.PathProfile")


def controller_module() -> ModuleType:
    """The module with ``Create`` for tool controllers."""
    return _first("Path.Tool.Controller", "PathScripts.PathToolController")


def _has_new_tool_bits() -> bool:
    return importlib.util.find_spec("Path.Tool") is not None and (
        importlib.util.find_spec("Path.Tool.toolbit") is not None
    )


PATTERN = ("ClearingPattern", "OffsetPattern")
"""Property of a pocket with the pattern in which it is cleared: of FreeCAD 1.x, and of 0.20."""


def prepare_modules() -> None:
    """Import the machining modules, so that their objects come to life when a document is opened."""
    for module in (job_module, profile_module, controller_module):
        module()


def has_window() -> bool:
    """Whether FreeCAD runs with its window, so that objects need view providers."""
    return bool(FreeCAD.GuiUp)


# Jobs and operations ---------------------------------------------------------------------------------


def is_job(obj: DocumentObject) -> bool:
    """Whether an object is a machining job."""
    return all(hasattr(obj, name) for name in ("Operations", "Model", "Tools", "PostProcessor"))


def jobs(document: Any) -> list[DocumentObject]:
    """Jobs of a document."""
    return [obj for obj in document.Objects if is_job(obj)]


_DATUMS = ("App::OriginFeature", "App::DatumElement", "Part::Datum")


def is_datum(obj: DocumentObject) -> bool:
    """Whether an object is an axis, a plane or a point that all else is placed by; since 1.0 these have shapes."""
    return any(obj.isDerivedFrom(kind) for kind in _DATUMS)


def no_models(job: DocumentObject) -> list[DocumentObject]:
    """What has a shape in a job and is no part: its stock, the tools with all they are made of, the group of models."""
    controllers = [] if job.Tools is None else list(job.Tools.Group)
    tools = [controller.Tool for controller in controllers if hasattr(controller.Tool, "Name")]
    made_of = [obj for tool in tools for obj in tool.OutListRecursive]
    return [obj for obj in (getattr(job, "Stock", None), job.Model, *tools, *made_of) if obj is not None]


def operations(job: DocumentObject) -> list[DocumentObject]:
    """Operations and dressups of a job, in the order in which they are machined."""
    group = job.Operations
    return [] if group is None else list(group.Group)


def is_operation(obj: DocumentObject) -> bool:
    """Whether an object is an operation or a dressup: it has a path and is no job or tool controller."""
    return obj.isDerivedFrom("Path::Feature") and hasattr(obj, "Path") and not is_job(obj) and not is_controller(obj)


def is_controller(obj: DocumentObject) -> bool:
    """Whether an object is a tool controller."""
    return hasattr(obj, "Tool") and hasattr(obj, "ToolNumber")


def is_dressup(obj: DocumentObject) -> bool:
    """Whether an operation dresses up another one: its Base is one object with a path."""
    base = getattr(obj, "Base", None)
    return getattr(base, "Path", None) is not None and is_operation(base)


def bottom_operation(obj: DocumentObject) -> DocumentObject:
    """The operation underneath any number of dressups."""
    seen = {obj.Name}
    while is_dressup(obj):
        obj = obj.Base
        if obj.Name in seen:
            raise InputError(phrase("the dressups of {} form a ring", obj.Label))
        seen.add(obj.Name)
    return obj


def parent_job(obj: DocumentObject) -> DocumentObject | None:
    """The job in which an operation is machined, also where a dressup lies over it; None without one."""
    for job in jobs(obj.Document):
        for operation in operations(job):
            here = operation
            while True:
                if here.Name == obj.Name:
                    return job
                if not is_dressup(here):
                    break
                here = here.Base
    return None


def replace_operation(job: DocumentObject, old: DocumentObject, new: DocumentObject) -> None:
    """Put one operation in another's place in the job's sequence; at the end where the other is not there."""
    group = [obj for obj in operations(job) if obj.Name != new.Name]
    names = [obj.Name for obj in group]
    if old.Name in names:
        group[names.index(old.Name)] = new
    else:
        group.append(new)
    job.Operations.Group = group


def is_active(obj: DocumentObject) -> bool:
    """Whether an operation, and every operation below it, is switched on."""
    while True:
        if not getattr(obj, "Active", True):
            return False
        if not is_dressup(obj):
            return True
        obj = obj.Base


def tool_controller(obj: DocumentObject) -> DocumentObject | None:
    """Tool controller of an operation, or of the operation below a dressup."""
    return getattr(bottom_operation(obj), "ToolController", None)


def tool_diameter(obj: DocumentObject) -> float:
    """Diameter of an operation's tool in mm.

    Raises
    ------
    InputError
        If the operation has no tool, or a tool without a diameter.
    """
    controller = tool_controller(obj)
    diameter = getattr(getattr(controller, "Tool", None), "Diameter", None)
    if diameter is None:
        raise InputError(phrase("{}: the operation has no tool with a diameter; set ToolDiameter", obj.Label))
    value = float(getattr(diameter, "Value", diameter))
    if value <= 0:
        raise InputError(phrase("{}: the tool's diameter is {}; set ToolDiameter", obj.Label, mm(value, "g")))
    return value


def path_of(obj: DocumentObject) -> Any:
    """Path of an operation in the job's frame, its placement applied where FreeCAD posts it so.

    FreeCAD 0.20 ignores placements when it posts; there the path is taken as it stands.
    """
    placed = getattr(importlib.import_module("PathScripts.PathUtils"), "getPathWithPlacement", None)
    return obj.Path if placed is None else placed(obj)


def global_placement(obj: DocumentObject) -> Any:
    """Placement of an object in the document, with those of the parts and bodies it lies in."""
    # A link has no such method, and stands in nothing's frame but its own.
    found = getattr(obj, "getGlobalPlacement", None)
    return obj.Placement if found is None else found()


def shape_in_document(obj: DocumentObject) -> Any:
    """Shape of an object where it stands in the document, with the placements of the parts and bodies it lies in.

    Raises
    ------
    InputError
        If it has none.
    """
    shape = Part.getShape(obj)
    if shape.isNull():
        raise InputError(phrase("{} has no shape to take as nominal profile", obj.Label))
    return moved(shape, global_placement(obj).multiply(obj.Placement.inverse()))


def moved(shape: Any, placement: Any) -> Any:
    """Copy of a shape, moved by a placement."""
    out = shape.copy()
    out.Placement = placement.multiply(out.Placement)
    return out


def give_views(job: DocumentObject) -> None:
    """Give a job and its Profile operations FreeCAD's own view providers where they have none.

    A document written without a window holds none; without them the tree falls apart when it is opened with
    one: the job shows neither operations nor tools below it.
    """
    if not has_window() or job.ViewObject is None or getattr(job.ViewObject, "Proxy", None):
        return
    gui = _first("Path.Main.Gui.Job", "PathScripts.PathJobGui")
    job.ViewObject.Proxy = gui.ViewProvider(job.ViewObject)
    job.ViewObject.addExtension("Gui::ViewProviderGroupExtensionPython")
    job.ViewObject.Proxy.deleteOnReject = False
    job.Stock.ViewObject.Visibility = False
    controllers = _first("Path.Tool.Gui.Controller", "PathScripts.PathToolControllerGui")
    for controller in job.Tools.Group:
        if not getattr(controller.ViewObject, "Proxy", None):
            controllers.ViewProvider(controller.ViewObject)
    page = _first("Path.Op.Gui.Profile", "PathScripts.PathProfileGui").Command.res
    base = _first("Path.Op.Gui.Base", "PathScripts.PathOpGui")
    for operation in operations(job):
        operation = bottom_operation(operation)
        if hasattr(operation, "processPerimeter") and not getattr(operation.ViewObject, "Proxy", None):
            operation.ViewObject.Proxy = base.ViewProvider(operation.ViewObject, page)
            operation.ViewObject.Proxy.deleteOnReject = False


# Making a job, for the demonstration and for tests ---------------------------------------------------


def make_job(document: Any, models: list[DocumentObject], name: str = "Job") -> DocumentObject:
    """New job of some models, posted for LinuxCNC."""
    FreeCAD.setActiveDocument(document.Name)
    job = job_module().Create(name, models, None)
    job.PostProcessor = "linuxcnc"
    return job


def set_end_mill(controller: DocumentObject, diameter: float) -> None:
    """Give a tool controller an end mill of a diameter in mm."""
    if controller.Tool is None:
        if _has_new_tool_bits():
            bit = importlib.import_module("Path.Tool.toolbit").ToolBit.from_shape_id("endmill.fcstd")
            controller.Tool = bit.attach_to_doc(doc=controller.Document)
        else:
            controller.Tool = _first("Path.Tool.Bit", "PathScripts.PathToolBit").Factory.Create()
    tool = controller.Tool
    tool.Diameter = f"{diameter} mm"
    tool.Label = f"End mill {diameter:g} mm"
    controller.Label = f"TC: {tool.Label}"


def make_profile(job: DocumentObject, name: str = "Profile") -> DocumentObject:
    """New Profile operation round the job's models, outside."""
    FreeCAD.setActiveDocument(job.Document.Name)
    return _in_job(profile_module().Create(name, parentJob=job), job)


def _in_job(operation: DocumentObject, job: DocumentObject) -> DocumentObject:
    if operation.Name not in [obj.Name for obj in operations(job)]:
        job.Operations.Group = [*operations(job), operation]
    if getattr(operation, "ToolController", None) is None:
        operation.ToolController = job.Tools.Group[0]
    return operation


def make_pocket(job: DocumentObject, name: str = "Pocket") -> DocumentObject:
    """New Pocket Shape operation of a job."""
    FreeCAD.setActiveDocument(job.Document.Name)
    module = _first("Path.Op.PocketShape", "PathScripts.PathPocketShape")
    return _in_job(module.Create(name, parentJob=job), job)


def set_pattern(pocket: DocumentObject, pattern: str) -> None:
    """Give a pocket the pattern in which it is cleared."""
    setattr(pocket, PATTERN[0] if hasattr(pocket, PATTERN[0]) else PATTERN[1], pattern)


# Post processing -------------------------------------------------------------------------------------


class _JobWithArguments:
    """A job as a post processor sees it, with other arguments; the job itself is left alone."""

    def __init__(self, job: DocumentObject, arguments: str) -> None:
        self._job = job
        self.PostProcessorArgs = arguments

    def __getattr__(self, name: str) -> Any:
        return getattr(self._job, name)


class _Fixture:
    """The start of a work frame, in the form that the post processors of 0.20 expect of an operation."""

    def __init__(self, job: DocumentObject, name: str) -> None:
        clearance = job.Stock.Shape.BoundBox.ZMax + job.SetupSheet.ClearanceHeightOffset.Value
        self.Name = self.Label = name
        self.Path = Path.Path([Path.Command(name), Path.Command("G0", {"Z": clearance})])
        self.InList = [job]


def _post_list(job: DocumentObject) -> list[Any]:
    """What FreeCAD 0.20 hands to a post processor for a job: frames, tool controllers, operations."""
    active = [obj for obj in operations(job) if is_active(obj)]
    if job.OrderOutputBy == "Operation":
        groups = [(job.Fixtures, [obj]) for obj in active]
    elif job.OrderOutputBy == "Tool":
        groups = []
        for obj in active:
            if groups and tool_controller(groups[-1][1][-1]) == tool_controller(obj):
                groups[-1][1].append(obj)
            else:
                groups.append((job.Fixtures, [obj]))
    else:
        groups = [([fixture], active) for fixture in job.Fixtures]
    out: list[Any] = []
    current = None
    for fixtures, group in groups:
        for fixture in fixtures:
            out.append(_Fixture(job, fixture))
            for obj in group:
                controller = tool_controller(obj)
                if controller is not None and controller != current:
                    out.append(controller)
                    current = controller
                out.append(obj)
    return out


def _texts(job: DocumentObject, name: str, arguments: str) -> list[str]:
    """What a post processor makes of a job."""
    try:
        module = importlib.import_module("Path.Post.Processor")
    except ModuleNotFoundError:
        processor = importlib.import_module("PathScripts.PathPostProcessor").PostProcessor.load(name)
        with tempfile.TemporaryDirectory() as directory:
            texts = [_given_or_written(processor, _post_list(job), pathlib.Path(directory) / "program.nc", arguments)]
    else:
        # The jobs of all earlier posts are kept there, and the first of them taken for the parent of a work frame.
        module._TempObject.InList.clear()
        processor = module.PostProcessorFactory.get_post_processor(_JobWithArguments(job, arguments), name)
        if processor is None:
            return []
        script = getattr(processor, "script_module", None)
        if script is None:
            texts = [text for _, text in processor.export() or []]
        else:
            # As FreeCAD calls them; what some then write to a file of that name must not lie about.
            with tempfile.TemporaryDirectory() as directory, contextlib.chdir(directory):
                parts = [part for _, part in processor._buildPostList()]
                texts = [_given_or_written(script, part, pathlib.Path("-"), arguments) for part in parts]
    return [text for text in texts if text]


def _given_or_written(script: Any, postables: list[Any], file: pathlib.Path, arguments: str) -> str:
    """What a post processor's script makes of some objects: some give the program back, some only write it."""
    given = script.export(postables, str(file), arguments)
    if isinstance(given, str) and given:
        return given
    return file.read_text(encoding="utf-8", errors="replace") if file.exists() else ""


def post(job: DocumentObject, arguments: str | None = None, wish: str = "") -> str:
    """NC text of a job, made by the FreeCAD post processor that the job names, or else by LinuxCNC's.

    Parameters
    ----------
    job : document object
        The job.
    arguments : str, optional
        Arguments of the post processor; default the job's own.
    wish : str
        One more argument, left out where the post processor does not know it.

    Returns
    -------
    str
        The program.

    Raises
    ------
    InputError
        If the post processor fails, makes no program, or several.
    """
    name = job.PostProcessor or "linuxcnc"
    arguments = job.PostProcessorArgs if arguments is None else arguments
    if "--no-show-editor" not in arguments:
        arguments = f"{arguments} --no-show-editor".strip()
    try:
        try:
            texts = _texts(job, name, f"{arguments} {wish}".strip())
        except SystemExit:
            # So end those that do not know an argument, or want one more.
            texts = _texts(job, name, arguments)
    except (Exception, SystemExit) as error:  # noqa: BLE001
        told = (
            f"{type(error).__name__}: {error}"
            if isinstance(error, Exception)
            else "an argument that is missing or that it does not know"
        )
        raise InputError(
            phrase(
                "{}: FreeCAD's own post processor {} fails on this job ({}): post with another one",
                job.Label,
                name,
                told,
            )
        ) from error
    if not texts:
        raise InputError(phrase("{}: FreeCAD's post processor {} made no program", job.Label, name))
    if len(texts) > 1:
        raise InputError(
            phrase("{}: FreeCAD's post processor made {} programs; clear SplitOutput", job.Label, len(texts))
        )
    return str(texts[0])


FEM_FORCE = "Fem::ConstraintForce"
_FEM_LOADS = (
    FEM_FORCE, "Fem::ConstraintPressure", "Fem::ConstraintBearing", "Fem::ConstraintTemperature",
    "Fem::ConstraintSelfWeight", "Fem::ConstraintCentrif",
)  # fmt: skip


def is_fem_load(member: DocumentObject) -> bool:
    """Whether a member of an analysis of FEM loads it."""
    kind = getattr(getattr(member, "Proxy", None), "Type", member.TypeId)
    return kind in _FEM_LOADS


def newtons(force: DocumentObject) -> float:
    """How large the force of a FEM constraint is, in N."""
    # A quantity since FreeCAD 0.21, a number before.
    return float(force.Force.getValueAs("N")) if hasattr(force.Force, "getValueAs") else float(force.Force)
