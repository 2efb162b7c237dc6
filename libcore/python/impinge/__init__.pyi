# SPDX-License-Identifier: GPL-3.0-or-later
"""What the module has, with shapes and units. Lengths in mm, angles in degrees, hours on the clock of the socket (12
superior, 3 anterior on both sides).

Poses are
  * angles, shape (n, 3) or (3,): flexion, abduction and internal rotation, joint coordinate system of Grood and
    Suntay 1983, 0 in the pose of the scan, or with landmarks of the femur where it is neutral; abduction and rotation
    need the side;
  * a text as "flexion=90,internal_rotation=10";
  * matrices, shape (n, 4, 4), (n, 3, 4) or one of them: x' = M x in the frame of the meshes, mm; they and
    quaternions begin at the pose of the scan, and are refused beside landmarks of the femur;
  * quaternions w, x, y, z of length 1, shape (n, 4) or (4,), (n, 1, 4) for 3 or 4 of them (which have the shape of one
    matrix): turns about the centre of rotation in the axes of the meshes.
Arrays of doubles in C order are read where they are; others are copied once. Long questions run without Python's lock,
and Ctrl-C ends many poses, many motions and the volume; the other questions end when they are answered. Errors are
ValueError for what is given, FileError or RuntimeError for meshes, with one line that says what to do; what looks wrong in
a joint is a UserWarning, and in Joint.warnings; matrices that move the ball farther than its radius, and limits of a gap
that is there from the start, are a UserWarning too."""
from os import PathLike
from typing import Any, Literal, Sequence, TypedDict

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str  # of the clone that it was built from

class FileError(RuntimeError):
    """A file, or a mesh, that cannot be used."""

# From the schemas of documents: stubs.py.
class Contact(TypedDict):
    state: Literal["no", "yes", "unknown"]  # no, yes, or unknown where only an opening of a mesh could tell
    by: Literal["surfaces", "inside", "radii"] | None  # by what it was told: surfaces meet, one bone is inside the other, or radii overlap
    ball_part: str | None  # part of the ball's bone that touches; null: its main surface, or no contact
    socket_part: str | None  # the same of the socket's

class SmallestGap(TypedDict):
    gap_mm: float  # along the ray from the centre; below 0 the main surfaces overlap (mm)
    error_bound_mm: float | None  # proven bound on its error; null where there is none (mm)
    euclidean_distance_mm: list[float] | None  # proven ends of the vertex' distance from the other surface; null if not asked for (mm)
    surface: Literal["ball", "socket"]  # whose vertex it is
    vertex: int  # its place in the mesh
    position: list[float]  # x, y, z in the pose, frame of the meshes (mm)
    clock: str | None  # on the rim's clock; null where the socket has none

class NearestPart(TypedDict):
    distance_mm: float  # of their surfaces; 0 in contact (mm)
    touch: bool | None  # do they? null where only an opening of a mesh could tell
    ball_part: str | None  # part of the ball's bone; null: its main surface
    socket_part: str | None  # part of the socket's bone; null: its main surface

class TouchAnswer(TypedDict):
    contact: Contact  # of all bones, decided exactly
    smallest_gap: SmallestGap | None  # of a vertex of the main surfaces; null where they do not face each other
    nearest_part: NearestPart | None  # the bones nearest to each other of which one is a part; null without parts

class Ball(TypedDict):
    impinged: int  # vertices with a gap of 0 or less, exactly
    clear_by_bound: int  # vertices that gap and bound prove clear
    impinged_by_bound: int  # vertices that they prove impinged
    undecided_by_bound: int  # vertices that they leave undecided
    without_gap: int  # vertices without a gap
    bounds_refuted: int  # verdicts by bound that the exact test contradicts

class Socket(TypedDict):
    impinged: int  # vertices with a gap of 0 or less, exactly
    clear_by_bound: int  # vertices that gap and bound prove clear
    impinged_by_bound: int  # vertices that they prove impinged
    undecided_by_bound: int  # vertices that they leave undecided
    without_gap: int  # vertices without a gap
    bounds_refuted: int  # verdicts by bound that the exact test contradicts

class RadialOverlap(TypedDict):
    overlap: bool  # does the ball reach the socket along some ray? Exact, between vertices too
    deepest_mm: float | None  # along a ray; null without overlap (mm)
    deepest_at: Literal["ball vertex", "socket vertex", "crossing of edges", "centre of the ball"] | None  # what is there
    ball: Ball  # of its vertices
    socket: Socket  # of its vertices

class ClockZone(TypedDict):
    clock_from: str  # on the rim's clock
    clock_to: str  # on the rim's clock
    area_mm2: float  # in this stretch (mm^2)

class ImpingementBall(TypedDict):
    vertices: int  # with such a gap
    area_mm2: float  # of their share of the faces (mm^2)
    clock_zones: list[ClockZone] | None  # stretches of the rim's clock, the largest first; null without a clock

class ImpingementSocket(TypedDict):
    vertices: int  # with such a gap
    area_mm2: float  # of their share of the faces (mm^2)
    clock_zones: list[ClockZone] | None  # stretches of the rim's clock, the largest first; null without a clock

class Impingement(TypedDict):
    gap_up_to_mm: float | None  # gaps up to this count; null where a map says how thick the cartilage is (mm)
    meaning: str  # bone on bone, or cartilage on cartilage
    ball: ImpingementBall  # of the ball's vertices
    socket: ImpingementSocket  # of the socket's vertices

class GapHistogramBall(TypedDict):
    area_mm2: list[float]  # of each bin (mm^2)
    below_mm2: float  # of smaller gaps (mm^2)
    beyond_mm2: float  # of larger gaps (mm^2)
    without_gap_mm2: float  # where the other surface is not met (mm^2)

class GapHistogramSocket(TypedDict):
    area_mm2: list[float]  # of each bin (mm^2)
    below_mm2: float  # of smaller gaps (mm^2)
    beyond_mm2: float  # of larger gaps (mm^2)
    without_gap_mm2: float  # where the other surface is not met (mm^2)

class GapHistogram(TypedDict):
    first_mm: float  # where the first bin begins (mm)
    bin_mm: float  # width of a bin (mm)
    ball: GapHistogramBall | None  # null if it was not asked about
    socket: GapHistogramSocket | None  # null if it was not asked about

class ErrorBound(TypedDict):
    largest_mm: float  # finite bound on the error of a gap (mm)
    median_mm: float  # of the finite bounds (mm)
    vertices_without_bound: int  # with a gap, of whose error nothing is proven
    smallest_gap_between_mm: list[float]  # proven ends of the smallest gap (mm)
    vertices_measured_on_the_faces: int  # to find that out

class EuclideanDistance(TypedDict):
    smallest_between_mm: list[float]  # proven ends of the smallest distance of a vertex (mm)
    gaps_above_it_by_a_tenth: int  # vertices whose gap overstates their distance by a tenth and more
    largest_gap_over_it: float  # largest ratio of gap and distance

class Dial(TypedDict):
    twelve: list[float]  # direction of twelve o'clock: right, anterior, superior
    three: list[float]  # direction of three o'clock

class ColoursBall(TypedDict):
    up_to: float | None  # mm, or of a cartilage map the share of its thickness; null for the last
    meaning: str  # as a legend says it
    rgb: list[int]  # 0 to 255

class ColoursSocket(TypedDict):
    up_to: float | None  # mm, or of a cartilage map the share of its thickness; null for the last
    meaning: str  # as a legend says it
    rgb: list[int]  # 0 to 255

class Colours(TypedDict):
    ball: list[ColoursBall]  # of ball.ply
    socket: list[ColoursSocket]  # of socket.ply
    no_gap_rgb: list[int]  # where the other surface is not met

class LeftOut(TypedDict):
    what: str  # in one word
    meaning: str  # what that leaves out
    reason: str  # with the numbers that it rests on
    bytes_saved: float | None  # of memory; null where none (bytes)

class GapsAnswer(TypedDict):
    contact: Contact | None  # of all bones, decided exactly; null if not asked for
    smallest_gap: SmallestGap | None  # of a vertex of the main surfaces; null where they do not face each other
    nearest_part: NearestPart | None  # the bones nearest to each other of which one is a part; null without parts, distances and verdicts
    radial_overlap: RadialOverlap | None  # of the main surfaces along rays, which is no contact by itself; null if not asked for
    impingement: list[Impingement]  # bone on bone, and cartilage on cartilage
    gap_histogram: GapHistogram  # area by gap
    error_bound: ErrorBound | None  # what is proven of the gaps' errors; null if not asked for
    euclidean_distance: EuclideanDistance | None  # beside the gaps; null if not asked for
    vertices_with_gap: list[int]  # of ball and socket
    precision_deg: float | None  # of the tables; null where the faces were measured (deg)
    entries_per_table: int  # 0 without tables
    table_bytes: int  # of both tables (bytes)
    dial: Dial | None  # where the rim's clock looks; null without one
    colours: Colours  # of the meshes that are written
    way: str  # how the gaps were found, and why so
    left_out: list[LeftOut]  # what the question did not need

class PosesAnswerSmallestGap(TypedDict):
    pose: int  # from 1
    gap_mm: float  # along a ray (mm)
    surface: str  # whose vertex it is
    vertex: int  # its place in the mesh
    clock: str | None  # on the rim's clock

class PosesAnswer(TypedDict):
    number_of_poses: int  # rows of poses.csv
    untracked: int  # of these without numbers
    touching: int | None  # of these in contact; null if not asked for
    unknown: int | None  # of these in which contact hangs on an opening of a mesh; null if not asked for
    smallest_gap: PosesAnswerSmallestGap | None  # of all poses; null if there is none or it was not asked for
    doubt: str | None  # what looks wrong with the poses; null if nothing does

class Motion(TypedDict):
    flexion: float  # of the femur forward; extension is negative (deg)
    abduction: float  # away from the midline; adduction is negative (deg)
    internal_rotation: float  # of the front towards the midline; external is negative (deg)

class Limit(TypedDict):
    motion: str  # what grows: fadir is internal rotation from 90 of flexion and 15 of adduction, faber external rotation from 45 of flexion and 30 of abduction, _at_90 from 90 of flexion
    threshold_mm: float  # 0: contact of the surfaces; else the gap of a vertex (mm)
    centre: str  # about whose centre the ball turns: ball or socket
    state: Literal["limited", "free", "blocked", "unknown"]  # limited; free up to the largest angle; blocked from the start; unknown beyond low_deg
    low_deg: float  # free up to here (deg)
    high_deg: float  # where limited, not free here (deg)
    centre_low_deg: float  # free up to here for every common centre within 0.5 mm (deg)
    centre_high_deg: float | None  # not free here for any such centre; null where that is not known (deg)
    half_mm_gap_deg: float | None  # where the gap of a vertex first falls to 0.5 mm (deg)
    clock: str | None  # where on the rim's clock they touch
    what: str  # what meets what, and what a reader must know
    play_low_deg: float  # free up to here for every play of the ball up to 0.5 mm (deg)
    play_high_deg: float | None  # not free here for any such play; null where that is not known (deg)
    hangs_on_less_than_half_mm: bool  # does half a millimetre change it by more than 5 degrees?
    start: Motion  # pose that the motion begins at
    largest_deg: float  # growth that was looked at (deg)
    centre_of_rotation: list[float]  # x, y, z in the frame of the meshes (mm)
    leaves_ball_mesh_deg: float | None  # from here on the ball's mesh ends under the socket (deg)
    ball_part: str | None  # what of the ball's bone touches; null without a contact
    socket_part: str | None  # what of the socket's bone touches
    meets: str | None  # what meets what, as rim and neck
    position: list[float] | None  # x, y, z where they touch, frame of the meshes (mm)
    contact: Literal["ball vertex", "socket vertex", "edges", "rims"] | None  # how they touch
    unknown_by: Literal["opening", "end of ball", "graze"] | None  # why nothing is known beyond low_deg: only an opening of a mesh could tell whether one bone is inside the other, the ball's mesh ends, or surfaces graze; null elsewhere

class LimitsAnswer(TypedDict):
    centre_within_mm: float  # how far off centres and play may be in the ranges (mm)
    rim: bool  # of the rim alone? Else of all bone
    rim_in_head_mm: float | None  # of the rim alone: how deep the rim lies in the head as scanned; there it meets the neck late or never. Null: nowhere (mm)
    limits: list[Limit]  # of each motion: contact about both centres, and the gap of the cartilage
    ball_cut_mm: float | None  # how far from the centre the ball's bone is cut off through its neck: what is missing beyond stops no motion, so that limits may be too large. Null: it is not (mm)

class VolumeAnswerMotion(TypedDict):
    motion: str  # its name (hip/named_motion.hpp)
    low_deg: float  # every rotation from its start to here is free (deg)
    high_deg: float | None  # here one is blocked; null where none is on the way (deg)
    clock: str | None  # on the dial, of the socket's face that may be touched first
    ball_direction: list[float] | None  # unit vector to the ball's face that may be touched first, at rest: right, anterior, superior
    ball_part: str | None  # part of the ball that may be touched first; null: the ball itself
    socket_part: str | None  # the same of the socket

class VolumeAnswer(TypedDict):
    share_low: float  # of all rotations that is free, at least
    share_high: float  # at most
    mobility_low_deg3: float  # volume that is free in Euler angles, weighted by the cosine of the middle one, whatever the axes (Manafzadeh and Gatesy 2020); of 14,851,066 in all, at least (deg^3)
    mobility_high_deg3: float  # at most (deg^3)
    reachable_low: float  # share that is reached without contact from where all angles are 0, at least
    reachable_high: float  # at most
    neutral_blocked: bool  # does contact block the pose in which all angles are 0?
    by_radii: bool  # does radial overlap block, too, as the socket is a sheet? `limits` may then go further
    unknown: float  # share of which nothing is known: the ball's mesh ends there
    open: float  # share that is undecided
    cells_asked: int  # cells of rotations that were decided
    motions: list[VolumeAnswerMotion]  # each named motion; none without a side

class Measure(TypedDict):
    measure: str  # its name
    value: float | None  # in `unit`; none where it is refused
    uncertainty: float | None  # in `unit`: how far it moves when it is measured otherwise
    unit: str  # mm, deg or 1
    state: str  # measured, or refused and why
    published_mean: float | None  # in `unit`, of a population; none without a source
    published_sd: float | None  # in `unit`: standard deviation
    published_median: float | None  # in `unit`, where the source has one in place of a mean
    published_lower_quartile: float | None  # in `unit`
    published_upper_quartile: float | None  # in `unit`
    published_of: str | None  # the group, and how it was measured
    published_source: str | None  # where

class MeasureAnswer(TypedDict):
    measures: list[Measure]  # each measure

class Least(TypedDict):
    volume_mm3: list[float] | None  # of bone that has to go, at least and at most; null where the mesh does not tell where bone is (mm^3)
    area_mm2: list[float]  # of the bone's surface that has to go, at least and at most (mm^2)
    depth_mm: list[float]  # the largest along a ray from the centre, at least and at most: to where the other bone is clear of it, or a closed mesh ends (mm)
    cells: int  # parts of the ball's surface in swept.csv

class Neck(TypedDict):
    least_mm: float  # that was to be left (mm)
    before_mm: float  # in the uncut ball, where it is cut (mm)
    after_mm: float  # in the cut ball (mm)

class Before(TypedDict):
    state: Literal["limited", "free", "blocked", "unknown"]  # how the search for first contact ended
    low_deg: float  # no contact from the start of the leg to here (deg)
    high_deg: float  # where limited, contact here (deg)

class After(TypedDict):
    state: Literal["limited", "free", "blocked", "unknown"]  # how the search for first contact ended
    low_deg: float  # no contact from the start of the leg to here (deg)
    high_deg: float  # where limited, contact here (deg)

class Leg(TypedDict):
    words: str  # as internal_rotation from 0 to 30 degrees at flexion 90
    motion: str  # the angle that grows
    start: Motion  # where the leg begins (deg)
    required_deg: float  # of growth (deg)
    before: Before  # first contact before the cut, up to what is required
    after: After  # and after it, up to 10 degrees more

class ResectAnswer(TypedDict):
    surface: Literal["ball", "socket"]  # which bone the least radial cut about the centre of rotation is of. It leaves no undercut, and narrows the bone behind the rim all the way out, where a cut that follows the rim could take less; of the socket it takes all bone nearer to the centre than the ball reaches, with the clearance
    volume_mm3: list[float] | None  # of bone that has to go, at least and at most; null where the mesh does not tell where bone is (mm^3)
    area_mm2: list[float]  # of the bone's surface that has to go, at least and at most (mm^2)
    depth_mm: list[float]  # the largest along a ray from the centre, at least and at most: to where the other bone is clear of it, or a closed mesh ends (mm)
    volume_why: str | None  # why there is no volume: the ball has to be closed, or met once by each ray of the cut; the socket closed, with the centre outside of its bone
    deepest: list[float] | None  # where the cut is deepest, x, y, z in the frame of the meshes; null: nothing has to go (mm)
    mesh_volume_mm3: float  # that the cut mesh takes away; null where there is no volume, or all of a wall of the socket goes (mm^3)
    least: Least | None  # of the least cut of all, if it was asked for: what the bone of the socket sweeps through within the clearance; bone beyond stays, over an undercut
    neck: Neck | None  # widest round bar about the axis of the neck that stays whole; null without a neck, or without a cut beside it
    legs: list[Leg]  # of the required paths; none touches after the cut

class AsScanned(TypedDict):
    inclination_deg: float  # radiographic (Murray 1993) (deg)
    anteversion_deg: float  # radiographic (Murray 1993) (deg)
    angles: str  # measured, measured to the end of the mesh, or given
    state: Literal["free", "blocked", "unknown", "open"]  # of the square of the map that holds it

class NearestFree(TypedDict):
    inclination_deg: float  # radiographic (deg)
    anteversion_deg: float  # radiographic (deg)
    inclination_change_deg: float  # from the socket as scanned (deg)
    anteversion_change_deg: float  # the same (deg)
    turn_deg: float  # angle of the one rotation about the centre that does both; the least there is (deg)
    turn_axis: list[float] | None  # unit vector in the frame of the meshes, by the right-hand rule; none where nothing turns
    at_least_deg: float  # no orientation of the map is free after a smaller turn: undecided ones may be (deg)

class Map(TypedDict):
    least_inclination_deg: float  # where it begins (deg)
    least_anteversion_deg: float  # where it begins (deg)
    width_deg: float  # of both angles (deg)
    squares: int  # that make it up

class AreaDeg2(TypedDict):
    free: float  # where every required motion is free (deg^2)
    blocked: float  # where one of them is blocked (deg^2)
    unknown: float  # where the ball's mesh ends under the socket on the way (deg^2)
    open: float  # undecided at the resolution (deg^2)

class OrientAnswer(TypedDict):
    as_scanned: AsScanned  # the socket as it is, its angles in the pelvis; it turns about the centre of rotation
    nearest_free: NearestFree | None  # by the angle of the turn that leads there; none where no square of the map is free
    map: Map  # which angles were looked at
    area_deg2: AreaDeg2  # of the map in each state (deg^2)
    by_radii: bool  # does radial overlap block, too, as the socket is a sheet? `limits` may then go further
    legs: list[str]  # parts of the required paths, in words

class CertifyAnswer(TypedDict):
    says: str  # clear: the surfaces do not meet; crossing: they do; inside: one body is inside the other
    to_deg: float | None  # how far along the motion that is proven; null for a pose (deg)
    closed: bool  # have all bodies no opening? What is open has no inside
    rounded_deg: float  # by how much the rotations differ from those asked for, at most (deg)

class ReportAnswer(TypedDict):
    gaps: GapsAnswer  # as `impinge gaps` has it, without bounds and distances
    limits: LimitsAnswer | None  # as `impinge limits` has it; null if left out
    volume: VolumeAnswer | None  # as `impinge volume` has it; null if left out
    measures: MeasureAnswer | None  # as `impinge measure` has it; null if left out

# End of these.

class Volume(VolumeAnswer):
    """A row a cell: level, cell (its number), w, x, y, z (quaternion in its middle, the largest coordinate 1: a rotation of the
    ball, axes right, anterior, superior), radius_deg, share, free, blocked, state (0 free, 1 blocked, 2 unknown, 3 undecided), reachable
    (1 certainly, 0 certainly not, -1 not known) and shift_x_mm, shift_y_mm, shift_z_mm (with play, of free cells; NaN elsewhere)."""

    cells: NDArray[Any]

class Resection(ResectAnswer):
    """Nothing here may guide a treatment."""

    vertices: NDArray[np.float64]  # (n, 3), mm, frame of the meshes: the bone that is left
    faces: NDArray[np.uint32]  # (m, 3)
    depth: NDArray[np.float64]  # (n,), mm along the ray of each vertex

class Orientation(OrientAnswer):
    """Nothing here may guide a treatment."""

    squares: NDArray[Any]  # structured: inclination_deg, anteversion_deg, half_width_deg, leg, state

class Certificate(CertifyAnswer):
    text: str  # of the certificate, which `impinge check` checks

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
    @property
    def clock(self) -> NDArray[np.float64]: ...  # (n,), hours of each vertex on the clock of the socket's rim, as scanned; NaN without one

Poses = ArrayLike | str
Motions = ArrayLike | str  # as poses: one motion, or several
Mesh = tuple[ArrayLike, ArrayLike]  # vertices (n, 3) in mm, faces (m, 3)
Point = Sequence[float] | NDArray[np.float64]
File = str | PathLike[str]
Marked = File | dict[str, Point]  # landmarks
Parts = File | Sequence[File] | dict[str, File | Mesh]  # files, called by their names, or by names

class Joint:
    """A ball-and-socket joint of two meshes in one frame. It may be asked from several threads: gaps() runs at the same
    time in them, the other questions one after the other."""

    @staticmethod
    def read(
        ball: File,
        socket: File,
        *,
        side: str | None = None,
        axes: str | None = None,
        centre: Point | None = None,
        landmarks: Marked | None = None,
        keep: str = "all",
        overlap_mm: float = 0.0,
        ball_part: Parts | None = None,
        socket_part: Parts | None = None,
        cartilage_map: File | ArrayLike | None = None,
        ignore_rest_contact: bool = False,
    ) -> Joint:
        """PLY, STL, OBJ, OFF, VTP or VTK, in mm. side: "left" or "right", of the body. axes: where +x, +y and +z point, as "LPS"; what
        3D Slicer wrote into the headers where it is None, else RAS.
        centre of rotation: (x, y, z) in the frame of the meshes, that of the sphere that fits the ball where it is None.
        landmarks: markups of 3D Slicer (.mrk.json, .fcsv, its table) or a CSV label,x,y,z, mm, with the labels of `impinge --landmarks`; or a
        dict of places by these labels, in the frame of the meshes. They give the frame of the pelvis, and Joint.landmarks
        its tilt; with epicondyles that of the femur too, and the ball is turned to neutral, from which angles are then
        counted. keep: "all", or "largest", of each mesh the piece of the largest area alone. overlap_mm: to this depth
        along a ray the surfaces may overlap; the ball is taken so much smaller. ignore_rest_contact: by the least tenth of
        a millimetre with which nothing touches as scanned (Joint.summary["overlap_mm"] has it). ball_part, socket_part: other
        bone, or an implant, in the same frame. cartilage_map: its thickness by place, a CSV x,y,z,thickness_mm or (n, 4), mm, which
        gaps and report use alone."""
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
        ball_part: Parts | None = None,
        socket_part: Parts | None = None,
        cartilage_map: File | ArrayLike | None = None,
        ignore_rest_contact: bool = False,
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
    @property
    def summary(self) -> dict[str, Any]: ...  # `joint` of the program's documents: meshes, parts, centre, warnings
    def cartilage_of_scan(self) -> float:
        """A cartilage_mm that blocks nothing as scanned: the smallest gap there, mm, rounded down to 0.01."""
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
        """Do the surfaces touch or overlap, edges and all? Exact for each pose; shape (poses,). Where that hangs on
        an opening of a mesh, it is not known, and the array is a masked one, masked there."""
    def smallest_gap(self, poses: Poses) -> NDArray[Any]:
        """A structured array of shape (poses,): gap_mm, bound_mm (proven, on the error of that gap), clock
        (hours), vertex and surface (0 ball, 1 socket); NaN and -1 where the surfaces do not face each other."""
    # From the schemas of requests: stubs.py.
    def limits(
        self, motions: str | Sequence[str] = ..., pose: Poses | None = ..., largest_deg: float = ...,
        translation: list[float] | None = ..., cartilage_mm: float = ..., rim: bool = ...
    ) -> LimitsAnswer:
        """How far the joint turns before its bones meet, what meets what, and over which centres that holds. As
        `impinge limits`; each argument and key: help()."""
    def volume(
        self, width: float = ..., gap_mm: float = ..., centre_within_mm: float = ..., play_mm: float = ...
    ) -> Volume:
        """Which share of all rotations is free of contact, and can be reached: proven, to the edges. As `impinge
        volume`; each argument and key: help()."""
    def measure(self) -> MeasureAnswer:
        """Radii, offset, neck-shaft angle, torsion, alpha, version, coverage and other measures, beside published
        ones. As `impinge measure`; each argument and key: help()."""
    def resect(
        self, require: Motions | Sequence[str] = ..., clearance_mm: float = ..., cut: Literal["ball", "socket"]
        = ..., rim_mm: float | None = ..., neck_mm: float | None = ..., least: bool = ...
    ) -> Resection:
        """The bone that would have to go so that motions are reached: of the ball, or of the socket's rim. As
        `impinge resect`; each argument and key: help()."""
    def orient(
        self, require: Motions | Sequence[str] = ..., tilt_deg: float = ..., resolution_deg: float = ...,
        inclination_deg: float | None = ..., anteversion_deg: float | None = ...
    ) -> Orientation:
        """In which orientations of the socket motions are free, over inclination and anteversion. As `impinge
        orient`; each argument and key: help()."""
    def certify(self, pose: Poses | None = ..., motion: str | None = ...) -> Certificate:
        """A proof that a pose or motion is free of contact, or that bones touch, which others can check without this
        program. As `impinge certify`; each argument and key: help()."""
    def report(
        self, out: str | PathLike[str], pose: Poses = ..., without: list[Literal["limits", "volume",
        "measures"]] = ..., width: float = ..., cartilage_mm: float | None = ...
    ) -> ReportAnswer:
        """All of a joint on one page: bones coloured by gap, range of motion, rotations, measures, warnings. As
        `impinge report`; each argument and key: help()."""
    # End of these methods.
    def ask(self, question: str, **request: Any) -> dict[str, Any]:
        """The answer of `impinge QUESTION --json`: a question by its name, its request as keywords. "gaps" has arrays besides,
        `gap`, `bound` and `distance` (n, 2) by "ball" and "socket", mm; "poses" has `rows`, those of poses.csv."""
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
