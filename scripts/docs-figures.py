#!/usr/bin/env python3
"""Draws the small pictures of joints and force elements, docs/src/images/joint-*.svg, force-*.svg.

    scripts/docs-figures.py
"""

from math import atan2, cos, hypot, pi, radians, sin
from pathlib import Path

IMAGES = Path(__file__).resolve().parent.parent / "docs" / "src" / "images"
INK, FIRST, SECOND, MUTED = "#333333", "#2c7fb8", "#c0392b", "#8a8a8a"


class Figure:
    """A picture in pixels, y upwards, the origin at the lower left corner."""

    def __init__(self, width, height):
        self.width, self.height, self.parts = width, height, []

    def y(self, y):
        return self.height - y

    def add(self, text):
        self.parts.append(text)

    def line(self, x1, y1, x2, y2, color=INK, width=1.5, dash=""):
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        self.add(
            f'<line x1="{x1:.1f}" y1="{self.y(y1):.1f}" x2="{x2:.1f}" y2="{self.y(y2):.1f}" '
            f'stroke="{color}" stroke-width="{width}" stroke-linecap="round"{dashes}/>'
        )

    def path(self, points, color=INK, width=1.5, fill="none", closed=False):
        data = " ".join(f"{'L' if k else 'M'}{x:.1f},{self.y(y):.1f}" for k, (x, y) in enumerate(points))
        self.add(
            f'<path d="{data}{" Z" if closed else ""}" fill="{fill}" stroke="{color}" '
            f'stroke-width="{width}" stroke-linejoin="round" stroke-linecap="round"/>'
        )

    def circle(self, x, y, r, color=INK, fill="none", width=1.5):
        self.add(
            f'<circle cx="{x:.1f}" cy="{self.y(y):.1f}" r="{r}" fill="{fill}" stroke="{color}" '
            f'stroke-width="{width}"/>'
        )

    def bar(self, x1, y1, x2, y2, color):
        self.line(x1, y1, x2, y2, color, 13)

    def pin(self, x, y):
        self.circle(x, y, 5, INK, "white", 2)

    def block(self, x, y, w, h, angle=0, color=SECOND):
        c, s = cos(angle), sin(angle)
        corners = [(-w / 2, -h / 2), (w / 2, -h / 2), (w / 2, h / 2), (-w / 2, h / 2)]
        self.path([(x + c * a - s * b, y + s * a + c * b) for a, b in corners], color, 1.5, color, True)

    def ground(self, x, y, length, angle=0):
        """A hatched line, the hatching below it."""
        c, s = cos(angle), sin(angle)
        at = lambda a, b: (x + c * a - s * b, y + s * a + c * b)
        self.line(*at(-length / 2, 0), *at(length / 2, 0), INK, 2)
        k = -length / 2 + 8
        while k <= length / 2:
            self.line(*at(k, 0), *at(k - 7, -8), MUTED, 1)
            k += 9

    def arrow(self, x1, y1, x2, y2, color=INK, width=1.8):
        self.line(x1, y1, x2, y2, color, width)
        self.head(x2, y2, atan2(y2 - y1, x2 - x1), color)

    def head(self, x, y, a, color):
        tip = [(x, y)] + [(x - 9 * cos(a + d), y - 9 * sin(a + d)) for d in (0.4, -0.4)]
        self.path(tip, color, 1, color, True)

    def arc(self, x, y, r, start, end, color=INK, arrow=True, width=1.5):
        """Angles in degrees, counter-clockwise."""
        n = 40
        angles = [radians(start + (end - start) * k / n) for k in range(n + 1)]
        self.path([(x + r * cos(a), y + r * sin(a)) for a in angles], color, width)
        if arrow:
            turn = pi / 2 if end > start else -pi / 2
            self.head(x + r * cos(angles[-1]), y + r * sin(angles[-1]), angles[-1] + turn, color)

    def text(self, x, y, words, color=INK, anchor="middle", size=14):
        self.add(
            f'<text x="{x}" y="{self.y(y)}" fill="{color}" font-size="{size}" text-anchor="{anchor}" '
            f'font-family="sans-serif">{words}</text>'
        )

    def spring(self, x1, y1, x2, y2, color=INK, coils=6, half=7):
        length, a = hypot(x2 - x1, y2 - y1), atan2(y2 - y1, x2 - x1)
        at = lambda u, v: (x1 + u * cos(a) - v * sin(a), y1 + u * sin(a) + v * cos(a))
        lead = 0.15 * length
        step = (length - 2 * lead) / (2 * coils)
        points = [(0, 0), (lead, 0)]
        points += [(lead + (k + 0.5) * step, half * (1 if k % 2 else -1)) for k in range(2 * coils)]
        points += [(length - lead, 0), (length, 0)]
        self.path([at(*p) for p in points], color, 1.8)

    def damper(self, x1, y1, x2, y2, color=INK, half=7):
        length, a = hypot(x2 - x1, y2 - y1), atan2(y2 - y1, x2 - x1)
        at = lambda u, v: (x1 + u * cos(a) - v * sin(a), y1 + u * sin(a) + v * cos(a))
        box, rod = 0.35 * length, 0.52 * length
        self.line(*at(0, 0), *at(box, 0), color, 1.8)
        self.path([at(0.68 * length, half), at(box, half), at(box, -half), at(0.68 * length, -half)], color, 1.8)
        self.line(*at(rod, half - 2), *at(rod, 2 - half), color, 3)
        self.line(*at(rod, 0), *at(length, 0), color, 1.8)

    def axes(self, x, y, angle=0, length=38, color=INK, names=("x", "y")):
        for turn, name in ((0, names[0]), (pi / 2, names[1])):
            a = angle + turn
            self.arrow(x, y, x + length * cos(a), y + length * sin(a), color, 1.4)
            if name:
                self.text(round(x + (length + 10) * cos(a), 1), round(y + (length + 10) * sin(a) - 4, 1), name, color)

    def save(self, name):
        body = "\n".join(self.parts)
        (IMAGES / f"{name}.svg").write_text(
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" '
            f'width="{self.width}" height="{self.height}">\n'
            f'<rect width="{self.width}" height="{self.height}" fill="white"/>\n{body}\n</svg>\n'
        )


def revolute():
    f = Figure(320, 170)
    f.bar(30, 50, 160, 80, FIRST)
    f.bar(160, 80, 280, 140, SECOND)
    f.line(160, 80, 260, 80 + 100 * 30 / 130, MUTED, 1.2, "4 4")
    f.arc(160, 80, 80, 13, 26)
    f.text(288, 108, "angle")
    f.pin(160, 80)
    f.text(80, 84, "first", FIRST)
    f.text(200, 130, "second", SECOND)
    f.arrow(160, 80, 160, 30, SECOND)
    f.text(170, 34, "reaction on second", SECOND, "start", 12)
    f.save("joint-revolute")


def prismatic():
    f = Figure(320, 170)
    a = radians(18)
    c, s = cos(a), sin(a)
    at = lambda u, v: (48 + c * u - s * v, 35 + s * u + c * v)
    f.bar(*at(0, 0), *at(260, 0), FIRST)
    f.block(*at(170, 24), 64, 34, a, SECOND)
    f.axes(*at(0, 0), a, 46, INK, ("x", "y"))
    f.arrow(*at(2, 58), *at(168, 58))
    f.text(92, 134, "displacement")
    f.line(*at(170, 24), *at(170, 62), MUTED, 1, "3 3")
    f.text(250, 80, "first", FIRST)
    f.text(240, 152, "second", SECOND)
    f.save("joint-prismatic")


def weld():
    f = Figure(280, 150)
    f.bar(30, 35, 180, 35, FIRST)
    f.bar(180, 35, 180, 125, SECOND)
    f.path([(168, 47), (168, 62), (153, 47)], INK, 1, INK, True)
    f.text(95, 55, "first", FIRST)
    f.text(220, 90, "second", SECOND)
    f.save("joint-weld")


def distance():
    f = Figure(320, 150)
    f.block(60, 60, 70, 60, 0.2, FIRST)
    f.block(250, 95, 70, 50, -0.3, SECOND)
    f.line(75, 60, 240, 95, INK, 3)
    f.pin(75, 60)
    f.pin(240, 95)
    f.text(152, 92, "length")
    f.text(60, 108, "first", FIRST)
    f.text(250, 136, "second", SECOND)
    f.save("joint-distance")


def pin_slot():
    f = Figure(320, 160)
    a = radians(15)
    c, s = cos(a), sin(a)
    at = lambda u, v: (50 + c * u - s * v, 40 + s * u + c * v)
    f.line(*at(0, 0), *at(220, 0), FIRST, 34)
    f.line(*at(12, 0), *at(208, 0), "white", 14)
    f.bar(*at(140, 0), 120, 140, SECOND)
    f.pin(*at(140, 0))
    f.axes(*at(6, 0), a, 60, INK, ("x", "y"))
    f.text(296, 70, "first", FIRST)
    f.text(186, 138, "second", SECOND)
    f.save("joint-pin-slot")


def teeth(f, x, y, r, n, color, shift=0.0, rim=0.0):
    points = []
    for k in range(4 * n):
        a = 2 * pi * (k + 0.5) / (4 * n) + shift
        high = k % 4 in (0, 1)
        points.append((x + (r + (4 if high else -4)) * cos(a), y + (r + (4 if high else -4)) * sin(a)))
    f.path(points, color, 1.5, "none", True)
    f.circle(x, y, r, MUTED, "none", 0.8)


def gear():
    f = Figure(320, 180)
    teeth(f, 95, 85, 40, 14, FIRST, pi / 14 * 0.5)
    teeth(f, 195, 85, 60, 21, SECOND)
    f.line(95, 85, 195, 85, MUTED, 8)
    f.pin(95, 85)
    f.pin(195, 85)
    f.arc(95, 85, 52, 60, 130, FIRST)
    f.arc(195, 85, 72, 120, 60, SECOND)
    f.text(50, 150, "first", FIRST)
    f.text(270, 155, "second", SECOND)
    f.line(145, 81, 120, 28, MUTED, 1)
    f.text(118, 16, "carrier", INK, "middle", 12)
    f.save("joint-gear")


def rack():
    f = Figure(320, 170)
    teeth(f, 150, 100, 46, 16, FIRST)
    points = [(20, 40)]
    for k in range(17):
        x = 20 + 17 * k
        points += [(x, 50), (x + 6, 58), (x + 11, 58), (x + 17, 50)]
    points += [(309, 40)]
    f.path(points, SECOND, 1.5, "none", True)
    f.pin(150, 100)
    f.arc(150, 100, 58, 30, 110, FIRST)
    f.arrow(40, 24, 110, 24)
    f.text(122, 20, "x")
    f.text(72, 130, "first", FIRST)
    f.text(275, 22, "second", SECOND)
    f.save("joint-rack")


def cam():
    f = Figure(320, 210)
    points = []
    for k in range(121):
        a = 2 * pi * k / 120
        r = 34 + 15 * (1 - cos(a))
        points.append((120 + r * cos(a + 2.0), 80 + r * sin(a + 2.0)))
    f.path(points, FIRST, 2, "#dcebf5", True)
    f.pin(120, 80)
    # The point of the profile above the axis.
    top = min(points, key=lambda p: abs(p[0] - 120) + (0 if p[1] > 80 else 999))
    f.circle(120, top[1] + 13, 12, SECOND, "#f6dcd8", 2)
    f.bar(120, top[1] + 13, 120, 196, SECOND)
    f.pin(120, top[1] + 13)
    f.text(36, 40, "first", FIRST)
    f.text(165, 185, "second", SECOND)
    f.arrow(120, 80, *points[102], INK, 1.2)
    f.text(205, 92, "r(phi)", INK, "start")
    f.line(200, 94, (120 + points[102][0]) / 2, (80 + points[102][1]) / 2, MUTED, 1)
    f.save("joint-cam")


def rolling_on_line():
    f = Figure(320, 170)
    a = radians(8)
    f.ground(160, 36, 280, a)
    c, s = cos(a), sin(a)
    x, y = 160 + 20 * c - 50 * s, 36 + 20 * s + 50 * c
    f.circle(x, y, 50, SECOND, "#f6dcd8", 2)
    f.pin(x, y)
    f.line(x, y, x + 50 * sin(a), y - 50 * cos(a), MUTED, 1.2, "4 3")
    f.arc(x, y, 62, 120, 60, SECOND)
    f.axes(34, 20, a, 44, INK, ("", "y"))
    f.text(84, 36, "x")
    f.text(x - 14, y - 26, "r")
    f.text(292, 36, "first", INK)
    f.text(270, 130, "second", SECOND)
    f.save("joint-rolling-on-line")


def rolling_on_circle():
    f = Figure(320, 170)
    f.circle(110, 70, 55, FIRST, "#dcebf5", 2)
    a = radians(25)
    x, y = 110 + 85 * cos(a), 70 + 85 * sin(a)
    f.circle(x, y, 30, SECOND, "#f6dcd8", 2)
    f.line(110, 70, x, y, INK, 1.4)
    f.line(110, 70, 200, 70, MUTED, 1, "4 3")
    f.arc(110, 70, 40, 0, 25)
    f.text(172, 54, "psi")
    f.pin(110, 70)
    f.pin(x, y)
    f.text(60, 138, "first", FIRST)
    f.text(250, 130, "second", SECOND)
    f.save("joint-rolling-on-circle")


def force():
    f = Figure(280, 150)
    f.block(110, 70, 130, 70, 0.25, "#f6dcd8")
    x, y = 165, 112
    f.arrow(x, y, x + 80, y + 20, SECOND, 2.4)
    f.pin(x, y)
    f.text(210, 100, "value", SECOND)
    f.text(150, 126, "at", INK)
    f.axes(110, 70, 0.25, 34)
    f.save("force-force")


def moment():
    f = Figure(240, 150)
    f.block(120, 70, 120, 70, 0.25, "#f6dcd8")
    f.arc(120, 70, 50, -40, 130, SECOND, True, 2.4)
    f.text(185, 118, "value", SECOND)
    f.save("force-moment")


def actuator():
    f = Figure(320, 160)
    f.bar(30, 50, 160, 70, FIRST)
    f.bar(160, 70, 270, 130, SECOND)
    f.pin(160, 70)
    f.arc(160, 70, 44, -20, 75, SECOND, True, 2.2)
    f.arc(160, 70, 44, 230, 140, FIRST, True, 2.2)
    f.text(222, 62, "value", SECOND)
    f.text(88, 104, "&#8722;value", FIRST)
    f.save("force-actuator")


def spring_damper():
    f = Figure(340, 150)
    f.block(40, 60, 50, 60, 0.1, FIRST)
    f.block(290, 90, 56, 50, -0.2, SECOND)
    x1, y1, x2, y2 = 62, 62, 266, 88
    a = atan2(y2 - y1, x2 - x1)
    n = (-sin(a), cos(a))
    f.spring(x1 + 14 * n[0], y1 + 14 * n[1], x2 + 14 * n[0], y2 + 14 * n[1])
    f.damper(x1 - 14 * n[0], y1 - 14 * n[1], x2 - 14 * n[0], y2 - 14 * n[1])
    for x, y in ((x1, y1), (x2, y2)):
        f.line(x + 14 * n[0], y + 14 * n[1], x - 14 * n[0], y - 14 * n[1], INK, 1.8)
    f.text(158, 110, "k")
    f.text(170, 34, "c")
    f.text(40, 106, "first", FIRST)
    f.text(292, 132, "second", SECOND)
    f.save("force-spring-damper")


def torsion_spring():
    f = Figure(320, 160)
    f.bar(30, 70, 150, 70, FIRST)
    f.bar(150, 70, 250, 135, SECOND)
    points = []
    for k in range(161):
        t = k / 160
        a = 2 * pi * 2.5 * t + 0.58
        r = 6 + 30 * t
        points.append((150 + r * cos(a), 70 + r * sin(a)))
    f.path(points, INK, 1.8)
    f.text(70, 90, "first", FIRST)
    f.text(284, 106, "second", SECOND)
    f.save("force-torsion-spring")


def joint_spring():
    f = Figure(320, 130)
    f.ground(170, 30, 290)
    f.block(230, 54, 60, 36, 0, SECOND)
    f.line(40, 30, 40, 84, INK, 4)
    f.spring(40, 66, 200, 66)
    f.damper(40, 44, 200, 44)
    f.arrow(40, 100, 230, 100)
    f.text(140, 108, "coordinate of the joint", INK, "middle", 12)
    f.save("force-joint-spring")


def bushing():
    f = Figure(280, 180)
    f.circle(130, 85, 66, FIRST, "#dcebf5", 3)
    f.circle(130, 85, 58, INK, "#777777", 1)
    f.circle(140, 91, 24, SECOND, "#f6dcd8", 3)
    f.axes(130, 85, 0.0, 92)
    f.text(52, 150, "first", FIRST)
    f.text(215, 122, "second", SECOND)
    f.save("force-bushing")


def point_gravity():
    f = Figure(300, 140)
    f.circle(50, 50, 16, INK, "#f0d070", 1.5)
    f.circle(240, 100, 12, SECOND, "#f6dcd8", 2)
    f.line(50, 50, 240, 100, MUTED, 1.2, "4 4")
    f.arrow(228, 97, 165, 80, SECOND, 2.2)
    f.text(120, 84, "r")
    f.text(50, 18, "center")
    f.text(240, 122, "body", SECOND)
    f.save("force-point-gravity")


if __name__ == "__main__":
    IMAGES.mkdir(exist_ok=True)
    for draw in (
        revolute, prismatic, weld, distance, pin_slot, gear, rack, cam, rolling_on_line,
        rolling_on_circle, force, moment, actuator, spring_damper, torsion_spring, joint_spring,
        bushing, point_gravity,
    ):
        draw()
