// Plots that zoom, by dygraphs.
const PALETTE = ["#3a7bd5", "#e08214", "#2a9d63", "#c73e3e", "#8b6bc4", "#a1694f", "#d96aa7",
    "#7f8790"];
const DASHES = [null, [7, 4], [2, 3], [7, 3, 2, 3]];

// One row per abscissa: null where a curve has no point there, nan where it is interrupted
function rowsOf(data) {
    const places = [...new Set(data.series.flatMap(s => s.points.map(p => p[0])))];
    places.sort((a, b) => a - b);
    const banded = data.series.some(s => s.points.some(p => p.length > 2));
    const columns = data.series.map(s => new Map(s.points.map(([x, y, low, high]) => {
        const value = y === null ? NaN : y;
        return [x, banded ? [low ?? value, value, high ?? value] : value];
    })));
    return { banded, rows: places.map(x => [x, ...columns.map(c => c.has(x) ? c.get(x) : null)]) };
}

function plot(figure) {
    const data = JSON.parse(figure.querySelector("script").textContent);
    const { banded, rows } = rowsOf(data);
    const area = figure.appendChild(document.createElement("div"));
    const names = figure.appendChild(document.createElement("div"));
    area.className = "area";
    names.className = "names";
    const colour = (s, k) => s.kind === null ? PALETTE[k % PALETTE.length] : colourOf(s.kind);
    const drawn = () => data.series.map(colour);
    const short = value => String(Number(value.toPrecision(5)));
    const labels = data.series.map((s, k) =>
        data.series.some((o, l) => l < k && o.name === s.name) ? `${s.name} (${k + 1})` : s.name);
    const graph = new Dygraph(area, rows, {
        labels: [data.x, ...labels], colors: drawn(), customBars: banded, xlabel: data.x,
        ylabel: data.y, logscale: data.log, stepPlot: data.steps, valueRange: data.limits,
        connectSeparatedPoints: true, strokeWidth: 1.5, labelsDiv: names, fillAlpha: 0.25,
        legend: data.series.length > 1 ? "always" : "onmouseover", xRangePad: 4,
        drawPoints: rows.length < 30, pointSize: 2, gridLineWidth: 0.5,
        axisLineColor: "#8889", gridLineColor: "#8884",
        yRangePad: 4,
        includeZero: data.zero,
        axes: { x: { axisLabelFormatter: short, valueFormatter: short, pixelsPerLabel: 45 },
            y: { axisLabelFormatter: short, valueFormatter: short, axisLabelWidth: 55 } },
        series: Object.fromEntries(data.series.map((s, k) =>
            [labels[k], { strokePattern: DASHES[s.run % DASHES.length] }])),
    });
    document.addEventListener("colours", () => graph.updateOptions({ colors: drawn() }));
    figure.dataset.drawn = rows.length;
}

// Those in a folded part have no size before it is opened
function plotAll(part) {
    for (const figure of part.querySelectorAll("figure.plot:not([data-drawn])"))
        if (!figure.parentElement.closest("details:not([open])")) plot(figure);
}

for (const part of document.querySelectorAll("details"))
    part.addEventListener("toggle", () => plotAll(part));
plotAll(document);
