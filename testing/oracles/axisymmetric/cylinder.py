# SPDX-License-Identifier: GPL-3.0-or-later
"""A rigid ball without friction in the middle of an elastic cylinder that is fixed below and free at its side: finite
elements, which share nothing with the integral equation of BallOnLayer.h. Small strain, SI units."""

import numpy as np

ENDS = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], float)
SIDES = np.array([(0, -1), (1, 0), (0, 1), (-1, 0)], float)
GAUSS = ((-np.sqrt(0.6), 5 / 9), (0.0, 8 / 9), (np.sqrt(0.6), 5 / 9))


def serendipity(x, y):
    """Values of the eight functions of a quadratic quadrilateral, and their derivatives along x and y."""
    values, along_x, along_y = [], [], []
    for a, b in ENDS:
        values.append(0.25 * (1 + a * x) * (1 + b * y) * (a * x + b * y - 1))
        along_x.append(0.25 * a * (1 + b * y) * (2 * a * x + b * y))
        along_y.append(0.25 * b * (1 + a * x) * (2 * b * y + a * x))
    for a, b in SIDES:
        across, ahead = (x, y * b) if a == 0 else (y, x * a)
        values.append(0.5 * (1 - across * across) * (1 + ahead))
        along_x.append(-x * (1 + ahead) if a == 0 else 0.5 * a * (1 - y * y))
        along_y.append(0.5 * b * (1 - x * x) if a == 0 else -y * (1 + ahead))
    return np.array(values), np.array([along_x, along_y])


def graded(edge, even, end, growth=1.15):
    """Places from 0 on, `edge` apart up to `even`, then further and further apart."""
    places = [0.0]
    while places[-1] < end - 1e-12:
        edge = edge if places[-1] < even else growth * edge
        rest = end - places[-1]
        places.append(end if rest < 1.5 * edge else places[-1] + edge)
    return np.array(places)


def mesh(radius, height, edge, even):
    """Nodes (r, z), the top at z = 0, and elements."""
    r, z = graded(edge, even, radius), -graded(edge, min(even, height), height)[::-1]
    half = lambda places: np.insert(places, range(1, len(places)), (places[1:] + places[:-1]) / 2)  # noqa: E731
    r, z = half(r), half(z)
    numbers, nodes = -np.ones((len(r), len(z)), int), []
    for i in range(len(r)):
        for j in range(len(z)):
            if i % 2 == 0 or j % 2 == 0:
                numbers[i, j] = len(nodes)
                nodes.append((r[i], z[j]))
    corners = ((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1))
    elements = [[numbers[i + a, j + b] for a, b in corners]
                for i in range(0, len(r) - 2, 2) for j in range(0, len(z) - 2, 2)]
    return np.array(nodes), np.array(elements)


def stiffness(nodes, elements, young, poisson):
    lam, mu = young * poisson / (1 + poisson) / (1 - 2 * poisson), young / 2 / (1 + poisson)
    hooke = np.diag([2 * mu, 2 * mu, 2 * mu, mu])
    hooke[:3, :3] += lam
    places, all_K = nodes[elements], np.zeros((len(elements), 16, 16))
    for x, weight_x in GAUSS:
        for y, weight_y in GAUSS:
            values, slopes = serendipity(x, y)
            jacobi = np.einsum("in,end->eid", slopes, places)
            gradients = np.linalg.solve(jacobi, np.broadcast_to(slopes, (len(elements), *slopes.shape)))
            r = places[:, :, 0] @ values
            strain = np.zeros((len(elements), 4, 16))
            strain[:, 0, 0::2], strain[:, 1, 1::2] = gradients[:, 0], gradients[:, 1]
            strain[:, 2, 0::2] = values / r[:, None]
            strain[:, 3, 0::2], strain[:, 3, 1::2] = gradients[:, 1], gradients[:, 0]
            volume = 2 * np.pi * r * np.linalg.det(jacobi) * weight_x * weight_y
            all_K += volume[:, None, None] * (strain.transpose(0, 2, 1) @ hooke @ strain)
    freedoms = np.stack([2 * elements, 2 * elements + 1], 2).reshape(len(elements), 16)
    whole = np.zeros((2 * len(nodes), 2 * len(nodes)))
    np.add.at(whole, (freedoms[:, :, None], freedoms[:, None, :]), all_K)
    return whole


def loads_of_hats(r):
    """Forces on the nodes of the top, in columns, under pressure that is 1 at one of them and falls to 0 at the next."""
    loads = np.zeros((len(r), len(r)))
    for first in range(0, len(r) - 2, 2):
        for x, weight in zip(*np.polynomial.legendre.leggauss(4)):
            values = np.array([0.5 * x * (x - 1), 1 - x * x, 0.5 * x * (x + 1)])
            hats = np.array([max(-x, 0), 1 - abs(x), max(x, 0)])
            half = (r[first + 2] - r[first]) / 2
            area = 2 * np.pi * (r[first + 1] + half * x) * weight * half
            loads[first:first + 3, first:first + 3] += area * np.outer(values, hats)
    return loads


def force(young, poisson, height, radius, ball, depth, edge):
    """On the ball [N], so deep; edges of `edge` below it."""
    nodes, elements = mesh(radius, height, edge, 0.6 * ball)
    held = np.zeros(2 * len(nodes), bool)
    below, axis = np.flatnonzero(nodes[:, 1] < -height + 1e-12), np.flatnonzero(nodes[:, 0] == 0)
    held[2 * below] = held[2 * below + 1] = held[2 * axis] = True
    top = np.flatnonzero((nodes[:, 1] == 0) & (nodes[:, 0] < 0.8 * ball))
    top = top[:len(top) - (len(top) + 1) % 2]
    free = np.cumsum(~held) - 1
    whole = stiffness(nodes, elements, young, poisson)[np.ix_(~held, ~held)]
    unit = np.zeros((len(whole), len(top)))
    unit[free[2 * top + 1], range(len(top))] = 1
    r = nodes[top, 0]
    loads = loads_of_hats(r)
    answer = loads.T @ np.linalg.solve(whole, unit)[free[2 * top + 1]] @ loads
    overlap = loads.T @ (depth - ball + np.sqrt(ball * ball - r * r))
    touching = r < np.sqrt(ball * depth)
    for _ in range(60):  # Signorini's condition on the hats: pressure where they touch, none where a gap is
        pressure = np.zeros(len(r))
        pressure[touching] = np.linalg.solve(answer[np.ix_(touching, touching)], overlap[touching])
        after = np.where(touching, pressure >= 0, answer @ pressure < overlap - 1e-15)
        if (after == touching).all():
            break
        touching = after
    return (loads @ pressure).sum()
