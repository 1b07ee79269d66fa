"""Rectangles as Mitsuba has them."""


def square_to(vertices):
    """The rows of the matrix that takes the square [-1, 1]^2, whose front is where z points, to the
    rectangle with these four corners."""
    a, b, c, d = vertices
    u = [(y - x) / 2 for x, y in zip(a, b)]
    v = [(y - x) / 2 for x, y in zip(a, d)]
    n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    center = [(x + y) / 2 for x, y in zip(a, c)]
    return [list(row) for row in zip(u, v, n, center)] + [[0, 0, 0, 1]]
