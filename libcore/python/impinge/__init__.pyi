# SPDX-License-Identifier: GPL-3.0-or-later
"""What the module has, with shapes and units. Lengths in mm, angles in degrees, hours on the clock of the socket (12
superior, 3 anterior on both sides).

Poses are
  * angles, shape (n, 3) or (3,): flexion, abduction and internal rotation, 0 in the pose of the scan, joint coordinate
    system of Grood and Suntay 1983; abduction and rotation need the side;
  * a text as "flexion=90,internal_rotation=10";
  * matrices, shape (n, 4, 4), (n, 3, 4) or one of them: x' = M x in the frame of the meshes, mm.
Arrays of doubles in C order are read where they are; others are copied once. Long questions run without Python's lock,
and Ctrl-C ends many poses, many motions and the volume; the other questions end when they are answered. Errors are
ValueError for what is given, FileError or RuntimeError for meshes, with one line that says what to do; what looks wrong in
a joint is a UserWarning, and in Joint.warnings; matrices that move the ball farther than its radius, and limits of a gap
that is there from the start, are a UserWarning too."""
from os import PathLike
from typing import Any, Sequence, TypedDict

import numpy as np
from numpy.typing import ArrayLike, NDArray

class FileError(RuntimeError):
    """A file, or a mesh, that cannot be used."""

class Limit(TypedDict):
    """How far one motion goes, with the names of summary.json; degrees from the start."""

    motion: str
    threshold_mm: float  # 0: contact of the surfaces; else the gap of a vertex
    centre: str  # about whose centre the ball turns: ball or socket
    state: str  # limited, free, blocked, unknown
    low_deg: float  # free up to here
    high_deg: float  # where limited, not free here
    centre_low_deg: float  # for every common centre within 0.5 mm
    centre_high_deg: float | None
    play_low_deg: float  # for every play of the ball of up to 0.5 mm
    play_high_deg: float | None
    half_mm_gap_deg: float | None  # where the gap of a vertex first falls to 0.5 mm
    leaves_ball_mesh_deg: float | None  # from here on the ball's mesh ends under the socket
    clock: float | None  # hours, where the surfaces touch
    what: str  # what meets what, as "rim and neck", and marks, as in limits.csv
    position: tuple[float, float, float] | None  # the same, frame of the meshes

class VolumeMotion(TypedDict):
    """How far one of the named motions goes, as far as the cells know; degrees from its start."""

    motion: str
    low_deg: float  # every rotation up to here is free
    high_deg: float | None  # here one is blocked
    clock: str | None  # as 1:30, of the socket's face that may be touched first
    ball_direction: list[float] | None  # unit vector to the ball's, at rest; right, anterior, superior
    ball_part: str | None  # part of the ball that may be touched first
    socket_part: str | None

class Volume(TypedDict):
    """All rotations of the ball about its centre, with the names of volume.json. Shares are of all rotations."""

    share_low: float  # free, at least
    share_high: float  # free, at most
    reachable_low: float  # reached from the pose of the scan without contact, at least
    reachable_high: float  # at most
    neutral_blocked: bool  # is the pose of the scan?
    unknown: float  # the ball's mesh ends under the socket there
    open: float  # undecided
    cells_asked: int
    motions: list[VolumeMotion]  # none without a side
    cells: NDArray[Any]  # structured, a row a cell; see Joint.volume()

class Bracket(TypedDict):
    state: str  # limited, free, blocked, unknown
    low_deg: float  # free up to here
    high_deg: float  # where limited, not free here

class Motion(TypedDict):
    """Degrees from the pose of the scan."""

    flexion: float
    abduction: float
    internal_rotation: float

class Leg(TypedDict):
    """A part of a required path: one angle that grows from where the part before has ended."""

    words: str
    motion: str
    start: Motion
    required_deg: float  # of growth
    before: Bracket  # first contact before the cut, up to what is required
    after: Bracket  # and after it, up to 10 degrees more

class Neck(TypedDict):
    """Width of the widest round bar about the neck's axis that no cut enters, mm."""

    least_mm: float  # that was to be left
    before_mm: float
    after_mm: float

class Least(TypedDict):
    """As in ResectAnswer, of the least cut of all: what the bone of the socket sweeps through within the clearance."""

    volume_mm3: list[float] | None
    area_mm2: list[float]
    depth_mm: list[float]  # the most bone that goes along one ray
    cells: int  # parts of the ball's surface in swept.csv

class ResectAnswer(TypedDict):
    """The least radial cut, with the names of resection.json. Two numbers are ends: no less, no more."""

    surface: str  # ball or socket
    volume_mm3: list[float] | None  # of bone that has to go; None of an open socket
    volume_why: str | None  # why there is no volume
    area_mm2: list[float]  # of the bone's surface that has to go
    depth_mm: list[float]  # the largest, along rays from the centre
    deepest: list[float] | None  # where that is, frame of the meshes; None: nothing has to go
    mesh_volume_mm3: float | None  # that the mesh below takes away; None where it is open
    least: Least | None  # of the least cut of all, if it was asked for
    neck: Neck | None  # None without a neck, or without a cut beside it
    legs: list[Leg]
    vertices: NDArray[np.float64]  # (n, 3), mm, frame of the meshes: the bone that is left
    faces: NDArray[np.uint32]  # (m, 3)
    depth: NDArray[np.float64]  # (n,), mm along the ray of each vertex

class Orientation(TypedDict):
    """Radiographic angles (Murray 1993) of the socket as it is, degrees, and what the map says there."""

    inclination_deg: float
    anteversion_deg: float
    state: str  # free, blocked, unknown, open

class Map(TypedDict):
    """A square of angles, which the squares make up."""

    least_inclination_deg: float
    least_anteversion_deg: float
    width_deg: float
    squares: int

class Areas(TypedDict):
    """Of the map, square degrees."""

    free: float
    blocked: float
    unknown: float
    open: float

class OrientAnswer(TypedDict):
    """With the names of orientation.json."""

    as_scanned: Orientation
    map: Map
    area_deg2: Areas
    legs: list[str]  # parts of the required paths, in words
    squares: NDArray[Any]  # structured, a row a square; see Joint.orient()

class Measure(TypedDict):
    """With the names of measures.csv; libcore/hip/measure_list.hpp and published_measures.hpp say what they are."""

    measure: str
    value: float | None  # None where it is refused
    uncertainty: float | None  # how far it moves when it is measured a little otherwise
    unit: str  # mm, deg or 1
    state: str  # measured, measured to the end of the mesh, or refused: and why
    published_mean: float | None  # of a population, in `unit`; all of these are None without a source
    published_sd: float | None
    published_median: float | None  # where the source has one in place of a mean
    published_lower_quartile: float | None
    published_upper_quartile: float | None
    published_of: str | None  # the group, and how it was measured
    published_source: str | None

class MeasureAnswer(TypedDict):
    measures: list[Measure]

class Landmarks(TypedDict):
    """What landmarks say, degrees."""

    pelvic_tilt_deg: float  # of the anterior pelvic plane from upright in the scan; forward is positive
    scanned_flexion_deg: float | None  # of the femur in the scan; None without epicondyles
    scanned_abduction_deg: float | None
    scanned_internal_rotation_deg: float | None

class Surface:
    """The mesh of the ball or of the socket; views without a copy, for reading."""

    @property
    def vertices(self) -> NDArray[np.float64]: ...  # (n, 3), mm, about Joint.centre
    @property
    def faces(self) -> NDArray[np.uint32]: ...  # (m, 3), places of the corners, as the mesh has them
    @property
    def areas(self) -> NDArray[np.float64]: ...  # (n,), mm^2 of the surface that belong to each vertex

Poses = ArrayLike | str
Required = ArrayLike | str | Sequence[str]  # one motion, or several
Mesh = tuple[ArrayLike, ArrayLike]  # vertices (n, 3) in mm, faces (m, 3)
Point = Sequence[float] | NDArray[np.float64]
Marked = str | PathLike[str] | dict[str, Point]  # landmarks

class Joint:
    """A ball-and-socket joint of two meshes in one frame. It may be asked from several threads: gaps() runs at the same
    time in them, the other questions one after the other."""

    @staticmethod
    def read(
        ball: str | PathLike[str],
        socket: str | PathLike[str],
        *,
        side: str | None = None,
        axes: str | None = None,
        centre: Point | None = None,
        landmarks: Marked | None = None,
        keep: str = "all",
        overlap_mm: float = 0.0,
    ) -> Joint:
        """PLY, STL, OBJ or OFF, in mm. side: "left" or "right", of the body. axes: where +x, +y and +z point, as "LPS"; what
        3D Slicer wrote into the headers where it is None, else RAS.
        centre of rotation: (x, y, z) in the frame of the meshes, that of the sphere that fits the ball where it is None.
        landmarks: markups of 3D Slicer (.mrk.json) or a CSV label,x,y,z, mm, with the labels of `scene --landmarks`; or a
        dict of places by these labels, in the frame of the meshes. They give the frame of the pelvis, and Joint.landmarks
        its tilt; with epicondyles that of the femur too, and the ball is turned to neutral, from which angles are then
        counted. keep: "all", or "largest", of each mesh the piece of the largest area alone. overlap_mm: to this depth
        along a ray the surfaces may overlap; the ball is taken so much smaller."""
    @staticmethod
    def from_arrays(
        ball: Mesh,
        socket: Mesh,
        *,
        side: str | None = None,
        axes: str = "RAS",
        centre: Point | None = None,
        landmarks: Marked | None = None,
        keep: str = "all",
        overlap_mm: float = 0.0,
    ) -> Joint:
        """The same of arrays. Equal points become one."""
    @staticmethod
    def from_hip(preset: str = "normal", *, faces: int = 12000, **parameters: float | str) -> Joint:
        """A hip of hip_presets(), some of its hip_parameters() changed, as cam_height=3; centre (0, 0, 0), axes RAS."""
    @property
    def ball(self) -> Surface: ...
    @property
    def socket(self) -> Surface: ...
    @property
    def centre(self) -> NDArray[np.float64]: ...  # (3,), mm, frame of the meshes
    @property
    def fit(self) -> tuple[float, float] | None: ...  # radius and root mean square residual, mm; None: centre was given
    @property
    def side(self) -> str | None: ...
    @property
    def axes(self) -> str: ...
    @property
    def landmarks(self) -> Landmarks | None: ...  # None where none were given
    @property
    def warnings(self) -> list[str]: ...
    def gaps(
        self,
        poses: Poses,
        *,
        precision_deg: float | None = None,
        out: tuple[NDArray[np.float32], NDArray[np.float32]] | None = None,
    ) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Radial gaps of all vertices of the ball, shape (poses, vertices), and of the socket; NaN where the other
        surface is not met. Of the faces themselves; with precision_deg by tables of that spacing (a cube map), two to
        four times as fast: NaN then also in cells of a table that the other surface does not cover or jumps in. Such
        gaps are off most where an edge of the mesh crosses a cell; the 16 bits of an entry add at most
        r (Q - 1) / 131,068, r the largest radius and Q the largest inverse depth over the least: a few micrometres
        on a hip. `out`: arrays that are written into and returned."""
    def touch(self, poses: Poses) -> NDArray[np.bool_]:
        """Do the surfaces touch or overlap, edges and all? Exact for each pose; shape (poses,)."""
    def smallest_gap(self, poses: Poses) -> NDArray[Any]:
        """A structured array of shape (poses,): gap_mm, bound_mm (proven, on the error of that gap), clock
        (hours), vertex and surface (0 ball, 1 socket); NaN and -1 where the surfaces do not face each other."""
    def limits(
        self, motions: str | Sequence[str] | None = None, *, start: Poses | None = None, cartilage_mm: float = 4.0
    ) -> list[Limit]:
        """How far flexion, extension, abduction, adduction, internal_rotation and external_rotation go from a start (the
        pose of the scan) until bones touch, about both centres, and until a gap falls to the cartilage's thickness."""
    def volume(self, width: float = 0.05, gap_mm: float = 0.0, centre_within_mm: float = 0.0) -> Volume:
        """Of all rotations, which are free, and which can be reached from the pose of the scan: cells of rotations are
        halved until no more than `width` of all rotations is undecided. A gap of gap_mm counts as contact; with
        centre_within_mm for every centre within that. `cells` has the fields of volume.csv: level, cell (its number), w,
        x, y, z (quaternion in its middle, the largest coordinate 1: a rotation of the ball, axes right, anterior,
        superior), radius_deg, share, state (0 free, 1 blocked, 2 unknown, 3 undecided) and reachable (1 certainly, 0
        certainly not, -1 not known)."""
    def resect(
        self, require: Required, clearance_mm: float = 0.5, cut: str = "ball", rim_mm: float | None = None,
        neck_mm: float | None = None, least: bool = False
    ) -> ResectAnswer:
        """The least radial cut of the ball, or of the socket's rim (cut="socket"), with which `require` is reached and a
        radial gap of clearance_mm stays everywhere on the way: angles of shape (3,) or (n, 3), or texts as
        "flexion=90,internal_rotation=30", each along its path from the pose of the scan, flexion first, then abduction, then
        rotation. rim_mm: how far inside its rim a socket may be cut, 5 where it is None. neck_mm: least width of the bar
        about the neck's axis that stays whole, 70 % of the neck's where it is None. least: how large the least cut of all is
        too, for a socket that is a closed mesh. RuntimeError, with the place, where no such cut may be made. Nothing here may guide a treatment."""
    def orient(self, require: Required, tilt_deg: float = 0.0, resolution_deg: float = 0.1) -> OrientAnswer:
        """In which orientations of the socket about the centre `require` (as for resect()) is free, of inclination 0
        to 90 and anteversion -30 to 60 degrees, the pelvis tilted backwards by tilt_deg. `squares` has the fields
        inclination_deg and anteversion_deg (radiographic, of its middle), half_width_deg, leg (where it is not free, the
        place among `legs` of one that is so; else -1) and state (0 free, 1 blocked, 2 unknown, 3 undecided at that
        resolution). Nothing here may guide a treatment."""
    def measure(self) -> MeasureAnswer:
        """Alpha by the clock, offset, neck-shaft angle, torsion, version, coverage and more of both meshes, each with its
        uncertainty and, where the definition is the same, beside what is published of a population; one that a mesh does
        not carry is refused. They need the side."""
    def certificate(self, pose: Poses | None = None, *, motion: str | None = None) -> str:
        """The text of a proof that one pose (that of the scan where it is None) is without contact, or that its bodies
        touch; with `motion`, such as "flexion", that the way from there to 0.01 degrees before the limit is without
        contact (0.1 or 1 where surfaces graze). experiments/check_certificate.py checks it with the mesh files alone. RuntimeError where nothing can
        be proven."""
    def matrices(self, poses: Poses) -> NDArray[np.float64]:
        """x' = M x of each pose, frame of the meshes, mm; shape (poses, 4, 4)."""

class Scheme:
    """A sampling scheme: which directions a table samples, and what answers between them."""

    def __init__(self, name: str, precision_deg: float = 1.0) -> None:
        """One of schemes(), its entries so many degrees apart at the equator."""
    def __len__(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def label(self) -> str: ...
    @property
    def citation(self) -> str: ...
    @property
    def precision_deg(self) -> float: ...
    @property
    def size(self) -> int: ...  # entries
    @property
    def cells(self) -> int: ...
    @property
    def covering_radius_deg(self) -> float: ...  # largest angle from any direction to its nearest entry
    @property
    def stencil_radius_deg(self) -> float: ...  # largest angle from any direction to an entry that answers there
    def directions(self) -> NDArray[np.float64]:
        """Unit vectors of all entries, shape (size, 3)."""
    def stencils(
        self, directions: ArrayLike
    ) -> tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.int64]]:
        """Of directions of shape (n, 3) and any length: entries (n, 4), their weights (n, 4), which sum to 1, and cells
        (n,). An entry that is not read is -1, with weight 0."""

def schemes() -> list[str]:
    """Names of all sampling schemes."""

def hip_presets() -> list[str]:
    """Names of the hips that there are."""

def hip_parameters(preset: str = "normal") -> dict[str, float | str]:
    """The parameters of one; libcore/hip/hip_parameters.hpp defines them."""

def hip_parameter_ranges() -> dict[str, tuple[str, float, float]]:
    """Unit, least and largest value of each parameter but the side."""
