// blender_prelude.cpp: the Python functions that every exact Blender script begins with.
#include "exporters/blender.h"

namespace litmus {

const std::string_view kBlenderPrelude = R"python(
# ---- How a scene of the model becomes a Cycles scene: the same functions in every export ---------
import math, os, sys
from array import array
from collections import namedtuple
import bpy
from mathutils import Matrix

# Cycles drops a closure whose colour is under 1e-5, so colours are raised and lamps dimmed by this.
GAIN = 1e4

# What one frame shows: the lamp that is lit, where it stands if it moves, and the values of the nodes
# in "Light of this frame", in their order.
Frame = namedtuple("Frame", "label lamp place values")
frames = []
groups = {}                # node groups, made when first used
ambient_colour = (0, 0, 0)


def new_scene(name, width, height, samples=1):
    """An empty scene in which every setting that costs exactness is off. Pictures are `samples` times
    larger than the scene says: the mean of samples x samples pixels is one pixel of the scene."""
    if bpy.app.version >= (4, 0, 0):
        raise RuntimeError("this script is for Blender 3.4; 4.0 makes node groups another way")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    frames.clear()
    groups.clear()
    groups["light"] = light_group()
    scene = bpy.context.scene
    scene.name = name
    render, cycles = scene.render, scene.cycles
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y = width * samples, height * samples
    render.resolution_percentage = 100
    render.use_compositing = render.use_sequencer = False
    render.use_persistent_data = True            # keeps meshes between the frames
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_mode = "RGB"
    render.image_settings.color_depth = "32"     # half floats would cost 5e-4
    render.image_settings.exr_codec = "ZIP"
    cycles.device = "CPU"
    cycles.samples = 1                           # sample 0 lies in the middle of the filter,
    cycles.pixel_filter_type = "BLACKMAN_HARRIS"  # (that of BOX does not)
    cycles.filter_width = 0.01                   # and the filter in the middle of the pixel
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.light_sampling_threshold = 0          # no dim light is skipped at random
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = 0
    cycles.transmission_bounces = cycles.volume_bounces = cycles.transparent_max_bounces = 0
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.blur_glossy = 0
    if hasattr(cycles, "use_light_tree"):        # since 3.5
        cycles.use_light_tree = False
    cycles.caustics_reflective = cycles.caustics_refractive = False


# ---- Nodes ----------------------------------------------------------------------------------------

class Nodes:
    """Writes a node tree as expressions: a socket or a number goes in, a socket comes out."""

    def __init__(self, tree):
        self.tree, self.column, self.rows = tree, {}, {}

    def node(self, kind, *inputs, label="", **settings):
        node = self.tree.nodes.new(kind)
        node.label = label
        for key, value in settings.items():
            setattr(node, key, value)
        column = 0
        for socket, value in zip(node.inputs, inputs):
            if isinstance(value, bpy.types.NodeSocket):
                self.tree.links.new(value, socket)
                column = max(column, self.column[value.node.name] + 1)
            elif value is not None:
                socket.default_value = value
        self.column[node.name] = column
        row = self.rows[column] = self.rows.get(column, -1) + 1
        node.location = (180 * column, -180 * row)
        return node

    def math(self, operation, *inputs, label=""):
        return self.node("ShaderNodeMath", *inputs, operation=operation, label=label).outputs[0]

    def vector(self, operation, *inputs, label=""):
        node = self.node("ShaderNodeVectorMath", *inputs, operation=operation, label=label)
        return node.outputs["Value" if operation in ("DOT_PRODUCT", "LENGTH") else "Vector"]

    def scale(self, vector, factor, label=""):
        node = self.node("ShaderNodeVectorMath", vector, operation="SCALE", label=label)
        self.tree.links.new(factor, node.inputs["Scale"])
        column = self.column[factor.node.name] + 1
        self.column[node.name] = max(self.column[node.name], column)
        return node.outputs["Vector"]


def light_group():
    """What the materials must know of the lamp that is lit in a frame. The timeline animates it."""
    tree = bpy.data.node_groups.new("Light of this frame", "ShaderNodeTree")
    nodes = Nodes(tree)
    output = nodes.node("NodeGroupOutput")
    nodes.column[output.name] = 1
    output.location = (180, 0)
    for kind, name in (("ShaderNodeCombineXYZ", "Position, or direction towards the sun"),
                       ("ShaderNodeValue", "1 = position, 0 = direction"),
                       ("ShaderNodeRGB", "Diffuse"), ("ShaderNodeRGB", "Specular"),
                       ("ShaderNodeValue", "Ambient on"),
                       ("ShaderNodeValue", "Linear / range"),
                       ("ShaderNodeValue", "Quadratic / range^2")):
        node = nodes.node(kind, label=name)
        node.name = name
        tree.outputs.new({"ShaderNodeCombineXYZ": "NodeSocketVector", "ShaderNodeRGB":
                          "NodeSocketColor"}.get(kind, "NodeSocketFloat"), name)
        tree.links.new(node.outputs[0], output.inputs[name])
    return tree


def power_of_cosine(nodes, n, h, exponent):
    """(n.h)^exponent, 0 where n.h <= 0, for unit vectors, as exp(exponent * log(1 - |n - h|^2 / 2)):
    beside n.h = 1 single precision keeps |n - h|, but not n.h. Small x: log(1 - x) = -x - x^2/2 - x^3/3."""
    apart = nodes.vector("SUBTRACT", n, h, label="n - h")
    x = nodes.math("MULTIPLY", nodes.vector("DOT_PRODUCT", apart, apart), 0.5, label="x = 1 - n.h")
    series = nodes.math("MULTIPLY_ADD", nodes.math("MULTIPLY_ADD", x, 1 / 3, 0.5), x, 1.0)
    near = nodes.math("MULTIPLY", x, series, label="-log(1 - x), small x")
    rest = nodes.math("SUBTRACT", 1.0, x)
    far = nodes.math("MULTIPLY", nodes.math("LOGARITHM", rest, math.e), -1.0, label="-log(1 - x)")
    small = nodes.math("LESS_THAN", x, 0.01)
    loss = nodes.math("ADD", nodes.math("MULTIPLY", near, small),
                      nodes.math("MULTIPLY", far, nodes.math("SUBTRACT", 1.0, small)))
    power = nodes.math("EXPONENT", nodes.math("MULTIPLY", nodes.math("MULTIPLY", loss, exponent), -1.0))
    return nodes.math("MULTIPLY", power, nodes.math("LESS_THAN", x, 1.0), label="(n.h)^ns")


def attenuation(nodes, distance, linear, quadratic):
    """1 / (1 + (L/R) d) * 1 / (1 + (Q/R^2) d^2)"""
    l = nodes.math("MULTIPLY_ADD", distance, linear, 1.0)
    q = nodes.math("MULTIPLY_ADD", nodes.math("MULTIPLY", distance, distance), quadratic, 1.0)
    return nodes.math("DIVIDE", 1.0, nodes.math("MULTIPLY", l, q), label="attenuation")


def blinn_phong(kind):
    """The node group ka Ia + kd Id (l.n) + ks Is (h.n)^ns. The lamp brings attenuation and cone, Cycles
    the shadow.
    "surface": the normal of the geometry. kd Id (l.n) is Cycles' own Diffuse BSDF; the specular term
      is the colour of a Toon BSDF, which at size 1 is 1/(2 pi) on the lit side and 0 behind.
    "mesh": the attribute "shading normal" (Cycles bends smooth normals and rounds those of small
      triangles), both terms in the Toon BSDF.
    "shell": a sphere around the eye (Cycles does not show points from inside): a fine mesh that is
      shaded at the point where the sphere itself is."""
    if kind in groups:
        return groups[kind]
    tree = bpy.data.node_groups.new("Blinn-Phong, " + kind, "ShaderNodeTree")
    for name, socket in (("ka", "Color"), ("kd", "Color"), ("ks", "Color"), ("ns", "Float"),
                         ("Centre", "Vector"), ("Radius", "Float")):
        if name not in ("Centre", "Radius") or kind == "shell":
            tree.inputs.new("NodeSocket" + socket, name)
    tree.outputs.new("NodeSocketShader", "Shader")
    nodes = Nodes(tree)
    material = nodes.node("NodeGroupInput").outputs
    light = nodes.node("ShaderNodeGroup", node_tree=groups["light"]).outputs
    place, positional, diffuse, specular, ambient_on, linear, quadratic = list(light)[:7]
    geometry = nodes.node("ShaderNodeNewGeometry").outputs
    point, eye = geometry["Position"], geometry["Incoming"]
    brightness = None

    if kind == "surface":
        n = geometry["Normal"]
    elif kind == "mesh":
        attribute = nodes.node("ShaderNodeAttribute", attribute_name="shading normal")
        n = nodes.vector("NORMALIZE", attribute.outputs["Vector"])
        away = nodes.math("LESS_THAN", nodes.vector("DOT_PRODUCT", n, eye), 0.0, label="n.e < 0")
        n = nodes.scale(n, nodes.math("MULTIPLY_ADD", away, -2.0, 1.0), label="n, towards the eye")
    else:
        # |p + s e - c| = r for the small s, with p the point on the mesh and e towards the eye.
        centre, radius = material["Centre"], material["Radius"]
        offset = nodes.vector("SUBTRACT", point, centre)
        b = nodes.vector("DOT_PRODUCT", eye, offset)
        outside = nodes.math("SUBTRACT", nodes.vector("DOT_PRODUCT", offset, offset),
                             nodes.math("MULTIPLY", radius, radius))
        root = nodes.math("SQRT", nodes.math("SUBTRACT", nodes.math("MULTIPLY", b, b), outside))
        s = nodes.math("DIVIDE", outside, nodes.math("SUBTRACT", root, b))
        exact = nodes.vector("ADD", point, nodes.scale(eye, s))
        n = nodes.vector("NORMALIZE", nodes.vector("SUBTRACT", centre, exact))
        ratio = [attenuation(nodes, nodes.vector("LENGTH", nodes.vector("SUBTRACT", place, p)),
                             linear, quadratic) for p in (exact, point)]
        brightness = nodes.math("DIVIDE", *ratio, label="attenuation there / here")
        point = exact

    to_light = nodes.vector("SUBTRACT", place, nodes.scale(point, positional))
    l = nodes.vector("NORMALIZE", to_light, label="l")
    h = nodes.vector("NORMALIZE", nodes.vector("ADD", l, eye), label="h")
    power = power_of_cosine(nodes, n, h, material["ns"])
    # The Toon BSDF is 1/(2 pi) where the Diffuse BSDF is cosine/pi: hence the 2.
    power = nodes.math("MULTIPLY", power, 2 * GAIN)
    shiny = nodes.scale(nodes.vector("MULTIPLY", material["ks"], specular), power, label="ks Is (h.n)^ns")
    matt = nodes.vector("MULTIPLY", material["kd"], diffuse, label="kd Id")
    if kind == "surface":
        matt = nodes.vector("MULTIPLY", matt, (GAIN, GAIN, GAIN))
        lambert = nodes.node("ShaderNodeBsdfDiffuse", matt, 0.0).outputs[0]
        toon = nodes.node("ShaderNodeBsdfToon", shiny, 1.0, 0.0, component="DIFFUSE").outputs[0]
        lit = nodes.node("ShaderNodeAddShader", lambert, toon).outputs[0]
    else:
        cosine = nodes.vector("DOT_PRODUCT", n, l, label="l.n")
        facing = nodes.math("GREATER_THAN", cosine, 0.0)
        if brightness:
            facing = nodes.math("MULTIPLY", facing, brightness)
        both = nodes.vector("ADD", nodes.scale(matt, nodes.math("MULTIPLY", cosine, 2 * GAIN)), shiny)
        both = nodes.scale(both, facing)
        lit = nodes.node("ShaderNodeBsdfToon", both, 1.0, 0.0, component="DIFFUSE").outputs[0]

    # Ambient: seen by the camera, lights nothing else.
    seen = nodes.node("ShaderNodeLightPath").outputs["Is Camera Ray"]
    strength = nodes.math("MULTIPLY", seen, ambient_on)
    base = nodes.node("ShaderNodeRGB", label="Ia").outputs[0]
    base.default_value = (*ambient_colour, 1)
    glow = nodes.vector("MULTIPLY", material["ka"], base, label="ka Ia")
    emission = nodes.node("ShaderNodeEmission", glow, strength).outputs[0]
    nodes.node("NodeGroupOutput", nodes.node("ShaderNodeAddShader", lit, emission).outputs[0])
    groups[kind] = tree
    return tree


def ambient(colour):
    """Ia of the whole scene; call it before the first material is used."""
    global ambient_colour
    ambient_colour = colour


class material:
    """ka, kd, ks and ns. A Blender material is made for each kind of surface that uses it."""

    def __init__(self, name, ambient, diffuse, specular=(0, 0, 0), shininess=1):
        self.name, self.made = name, {}
        self.values = ((*ambient, 1), (*diffuse, 1), (*specular, 1), shininess)

    def on(self, kind, *more):
        key = (kind, *more)
        if key in self.made:
            return self.made[key]
        made = bpy.data.materials.new(self.name if kind == "surface" else f"{self.name} ({kind})")
        made.use_nodes = True
        made.cycles.sample_as_light = False     # its emission is ambient light, not a lamp
        made.node_tree.nodes.clear()
        nodes = Nodes(made.node_tree)
        shader = nodes.node("ShaderNodeGroup", node_tree=blinn_phong(kind))
        for socket, value in zip(shader.inputs, self.values + more):
            socket.default_value = value
        nodes.node("ShaderNodeOutputMaterial", shader.outputs[0])
        self.made[key] = made
        return made


# ---- Surfaces -------------------------------------------------------------------------------------

def add_object(name, data, visible):
    thing = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(thing)
    thing.visible_camera = visible              # otherwise it only casts shadows
    return thing


def add_mesh(name, vertices, loops, starts, sizes, finish, visible):
    """vertices: 3 floats each; loops: indices; starts, sizes: one per polygon."""
    data = bpy.data.meshes.new(name)
    data.vertices.add(len(vertices) // 3)
    data.vertices.foreach_set("co", vertices)
    data.loops.add(len(loops))
    data.loops.foreach_set("vertex_index", loops)
    data.polygons.add(len(starts))
    data.polygons.foreach_set("loop_start", starts)
    data.polygons.foreach_set("loop_total", sizes)
    data.update(calc_edges=True)
    data.materials.append(finish)
    return add_object(name, data, visible)


def add_quads(name, corners, quads, finish, visible):
    add_mesh(name, array("f", [x for corner in corners for x in corner]),
             array("i", [i for quad in quads for i in quad]), array("i", range(0, 4 * len(quads), 4)),
             array("i", [4] * len(quads)), finish.on("surface"), visible)


def box(name, finish, low, high, visible=True):
    corners = [(x, y, z) for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])]
    quads = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    add_quads(name, corners, quads, finish, visible)


def plane(name, finish, rings, visible=True):
    """As much of an infinite plane as the picture and its shadows need: nested rectangles of 4 corners,
    the inner ones small, because Cycles is as exact as a quad is small."""
    corners = [corner for ring in rings for corner in ring]
    quads = [(0, 1, 2, 3)]
    for k in range(0, 4 * (len(rings) - 1), 4):
        for i in range(4):
            j = (i + 1) % 4
            quad = (k + i, k + j, k + 4 + j, k + 4 + i)
            if corners[quad[0]] != corners[quad[3]] or corners[quad[1]] != corners[quad[2]]:
                quads.append(quad)
    add_quads(name, corners, quads, finish, visible)


def face_normal(a, b, c):
    ux, uy, uz = b[0] - a[0], b[1] - a[1], b[2] - a[2]
    vx, vy, vz = c[0] - a[0], c[1] - a[1], c[2] - a[2]
    x, y, z = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    length = math.hypot(x, y, z) or 1.0
    return x / length, y / length, z / length


def mesh(name, finish, vertices, triangles, normals="", visible=True):
    """Texts of numbers, one vertex, triangle or vertex normal a line. Without normals it is flat, and
    the normals of the triangles are computed here, because Blender's own are single precision."""
    co = list(map(float, vertices.split()))
    index = list(map(int, triangles.split()))
    vertex = list(zip(co[0::3], co[1::3], co[2::3]))
    if normals:
        normal = list(map(float, normals.split()))
    else:
        normal = [x for a, b, c in zip(index[0::3], index[1::3], index[2::3])
                  for x in face_normal(vertex[a], vertex[b], vertex[c])]
    count = len(index) // 3
    thing = add_mesh(name, array("f", co), array("i", index), array("i", range(0, 3 * count, 3)),
                     array("i", [3]) * count, finish.on("mesh"), visible)
    attribute = thing.data.attributes.new("shading normal", "FLOAT_VECTOR", "POINT" if normals else "FACE")
    attribute.data.foreach_set("vector", array("f", normal))


def point_group():
    """Geometry nodes: a vertex becomes a point with a radius, which Cycles renders as a true sphere."""
    tree = bpy.data.node_groups.new("Vertex to sphere", "GeometryNodeTree")
    for kind, name in (("Geometry", "Geometry"), ("Float", "Radius"), ("Material", "Material")):
        tree.inputs.new("NodeSocket" + kind, name)
    tree.outputs.new("NodeSocketGeometry", "Geometry")
    nodes = Nodes(tree)
    given = nodes.node("NodeGroupInput").outputs
    points = nodes.node("GeometryNodeMeshToPoints", given["Geometry"])
    tree.links.new(given["Radius"], points.inputs["Radius"])
    painted = nodes.node("GeometryNodeSetMaterial", points.outputs[0])
    tree.links.new(given["Material"], painted.inputs["Material"])
    nodes.node("NodeGroupOutput", painted.outputs[0])
    return tree


def sphere(name, finish, centre, radius, visible=True):
    surface = finish.on("surface")
    data = bpy.data.meshes.new(name)
    data.from_pydata([centre], [], [])
    data.materials.append(surface)
    thing = add_object(name, data, visible)
    modifier = thing.modifiers.new("Sphere", "NODES")
    groups["sphere"] = groups.get("sphere") or point_group()
    modifier.node_group = groups["sphere"]
    radius_key, material_key = (socket.identifier for socket in groups["sphere"].inputs[1:3])
    modifier[radius_key], modifier[material_key] = float(radius), surface


def shell(name, finish, centre, radius, visible=True):
    """A sphere with the eye inside: an icosphere of 20,480 triangles, shaded as the sphere."""
    import bmesh
    data = bpy.data.meshes.new(name)
    build = bmesh.new()
    bmesh.ops.create_icosphere(build, subdivisions=6, radius=radius)
    bmesh.ops.translate(build, vec=centre, verts=build.verts)
    build.to_mesh(data)
    build.free()
    data.materials.append(finish.on("shell", centre, radius))
    add_object(name, data, visible)


# ---- Camera ---------------------------------------------------------------------------------------

def camera(eye, target, up, fov=None, height=None):
    """Perspective with the full vertical angle `fov` in radians, or orthographic with `height`."""
    back = unit([a - b for a, b in zip(eye, target)])
    right = unit(cross(up, back))
    upward = cross(back, right)
    data = bpy.data.cameras.new("Camera")
    data.sensor_fit = "VERTICAL"
    data.sensor_height = 24
    if fov is not None:
        data.lens = 12 / math.tan(fov / 2)
    else:
        data.type = "ORTHO"
        data.ortho_scale = height
    data.clip_start, data.clip_end = 1e-3, 1e7
    thing = add_object("Camera", data, True)
    set_axes(thing, right, upward, back, eye)
    bpy.context.scene.camera = thing


# ---- Lights ---------------------------------------------------------------------------------------

def add_lamp(name, kind, energy, shadows):
    data = bpy.data.lights.new(name, kind)
    data.energy = energy / GAIN
    data.cycles.use_multiple_importance_sampling = False
    data.cycles.cast_shadow = shadows
    if kind == "SUN":
        data.angle = 0
    else:
        data.shadow_soft_size = 0
    return add_object(name, data, True)


def set_axes(thing, x, y, z, origin):
    """Gives an object its matrix to the last digit, as a child of an object at the origin; location and
    angles would round it."""
    thing.parent = add_object(thing.name + " stand", None, True)
    rows = [(x[i], y[i], z[i], origin[i]) for i in range(3)]
    thing.matrix_parent_inverse = Matrix(rows + [(0, 0, 0, 1)])


def unit(v):
    length = math.hypot(*v)
    return [x / length for x in v]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def directional_light(name, direction, intensity, diffuse, specular, shadows=True):
    """A SUN of angle 0: pi times its intensity, for the Diffuse BSDF divides by pi."""
    lamp = add_lamp(name, "SUN", math.pi * intensity, shadows)
    towards = unit([-x for x in direction])      # a lamp shines along its -z
    smallest = min(range(3), key=lambda i: abs(towards[i]))
    x = unit(cross([1.0 if i == smallest else 0.0 for i in range(3)], towards))
    set_axes(lamp, x, cross(towards, x), towards, (0, 0, 0))
    frames.append(Frame(name, lamp, None, (towards, 0, diffuse, specular, 0, 0, 0)))


def positional_light(name, places, intensity, diffuse, specular, range=1, linear=0, quadratic=0,
                     axis=None, cutoff=None, exponent=None, shadows=True):
    """A POINT lamp of radius 0: 4 pi^2 times its intensity, because Cycles divides by 4 pi and by pi.
    Its nodes take the division by d^2 back and put l * q and the cone in its place. `places` has one
    position, or those of the grid of an area light: the lamp walks over it, a frame each."""
    lamp = add_lamp(name, "POINT", 4 * math.pi ** 2 * intensity / len(places), shadows)
    lamp.data.use_nodes = True
    lamp.data.node_tree.nodes.clear()
    nodes = Nodes(lamp.data.node_tree)
    falloff = nodes.node("ShaderNodeLightFalloff", 1.0, 0.0)
    if quadratic and not linear:
        # strength * t^2 / (smooth + t^2) of the node, divided by t^2, is R^2 / (R^2 + Q d^2)
        falloff.inputs["Strength"].default_value = range * range / quadratic
        falloff.inputs["Smooth"].default_value = range * range / quadratic
        strength = falloff.outputs["Quadratic"]
    else:
        strength = falloff.outputs["Constant"]
        if linear:
            distance = nodes.node("ShaderNodeLightPath").outputs["Ray Length"]
            strength = nodes.math("MULTIPLY", strength, attenuation(nodes, distance, linear / range,
                                                                    quadratic / range ** 2))
    if cutoff is not None:
        strength = nodes.math("MULTIPLY", strength, cone(nodes, axis, cutoff, exponent))
    shine = nodes.node("ShaderNodeEmission", (1, 1, 1, 1), strength)
    nodes.node("ShaderNodeOutputLight", shine.outputs[0])
    for i, place in enumerate(places):
        label = name if len(places) == 1 else f"{name} {i + 1}/{len(places)}"
        values = (place, 1, diffuse, specular, 0, linear / range, quadratic / range ** 2)
        frames.append(Frame(label, lamp, place, values))


def cone(nodes, axis, cutoff, exponent):
    """1 - (alpha / cutoff)^exponent inside the cone. The angle is atan2(|i x a|, i.a): an arccosine
    would lose half the digits near the axis."""
    axis = unit(axis)
    outward = nodes.node("ShaderNodeNewGeometry").outputs["Incoming"]
    sine = nodes.vector("LENGTH", nodes.vector("CROSS_PRODUCT", outward, axis))
    alpha = nodes.math("ARCTAN2", sine, nodes.vector("DOT_PRODUCT", outward, axis), label="alpha")
    ratio = nodes.math("DIVIDE", alpha, cutoff, label="alpha / cutoff")
    decay = nodes.math("SUBTRACT", 1.0, nodes.math("POWER", ratio, exponent), label="decay")
    return nodes.math("MULTIPLY", decay, nodes.math("LESS_THAN", ratio, 1.0))


# ---- Timeline, .blend, pictures -------------------------------------------------------------------

def keyframes(owner, path, values, index=0):
    """One key a frame that jumps, never blends."""
    if owner.animation_data is None:
        owner.animation_data_create()
    if owner.animation_data.action is None:
        owner.animation_data.action = bpy.data.actions.new(owner.name)
    curve = owner.animation_data.action.fcurves.new(path, index=index)
    curve.keyframe_points.add(len(values))
    curve.keyframe_points.foreach_set("co", [x for i, v in enumerate(values) for x in (i + 1, v)])
    curve.keyframe_points.foreach_set("interpolation", [0] * len(values))    # 0 is CONSTANT
    curve.update()


def animate():
    """Frame 1 is ambient light alone; then one lamp a frame."""
    dark = Frame("ambient", None, None, ((0, 0, 1), 0, (0, 0, 0), (0, 0, 0), 1, 0, 0))
    timeline = [dark] + frames
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = 1, len(timeline)
    for i, frame in enumerate(timeline):
        scene.timeline_markers.new(frame.label, frame=i + 1)
    tree = groups["light"]
    for k, node in enumerate(node for node in tree.nodes if node.type != "GROUP_OUTPUT"):
        column = [frame.values[k] for frame in timeline]
        if node.type == "VALUE":
            keyframes(tree, f'nodes["{node.name}"].outputs[0].default_value', column)
        elif node.type == "RGB":
            for c in range(3):
                keyframes(tree, f'nodes["{node.name}"].outputs[0].default_value', [v[c] for v in column], c)
        else:
            for c in range(3):
                keyframes(tree, f'nodes["{node.name}"].inputs[{c}].default_value', [v[c] for v in column])
    for lamp in dict.fromkeys(frame.lamp for frame in frames):
        dark = [0 if frame.lamp == lamp else 1 for frame in timeline]
        keyframes(lamp, "hide_render", dark)
        keyframes(lamp, "hide_viewport", dark)
        places = [frame.place for frame in frames if frame.lamp == lamp]
        if len(places) > 1:
            track = [frame.place if frame.lamp == lamp else places[0] for frame in timeline]
            for c in range(3):
                keyframes(lamp, "location", [place[c] for place in track], c)
        elif places[0]:
            lamp.location = places[0]
    scene.frame_set(1)


def finish(name):
    """Saves OUTDIR/name.blend and renders OUTDIR/name_0001.exr, ...; OUTDIR is the argument behind "--"."""
    arguments = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    folder = os.path.abspath(arguments[0] if arguments else ".")
    os.makedirs(folder, exist_ok=True)
    animate()
    scene = bpy.context.scene
    scene.render.filepath = os.path.join(folder, name + "_####")
    if "--no-blend" not in arguments:
        bpy.ops.wm.save_as_mainfile(filepath=os.path.join(folder, name + ".blend"), compress=True)
    bpy.ops.render.render(animation=True)
)python";

}  // namespace litmus
