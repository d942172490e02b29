
'use strict';
(() => {
  const canvases = document.querySelectorAll('canvas');
  const places = JSON.parse(document.getElementById('charts').textContent)
    .map((chart, i) => ({ chart, canvas: canvases[i], drawn: null }));
  const colour = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

  const hasLine = curve => curve.mark !== 'points' && curve.mark !== 'dots';

  // Dots are wider than lines: what is measured shows on both sides of one that is drawn over it.
  const radius = { points: 4, dots: 2.5 };

  const paint = (curve, k) => colour(curve.mark === 'dots' ? '--measured' : '--curve-' + k % 5);

  const dataset = (curve, k) => ({
    label: curve.name,
    data: curve.x.map((x, i) => ({ x, y: curve.y[i] })),
    showLine: hasLine(curve),
    pointStyle: 'circle',
    borderDash: curve.mark === 'dashed' ? [6, 4] : [],
    borderWidth: curve.mark === 'dashed' ? 2 : 1.6,
    pointRadius: radius[curve.mark] ?? 0,
    pointBorderWidth: 0,
    pointHitRadius: 6,
    borderColor: paint(curve, k),
    backgroundColor: paint(curve, k),
  });

  // Ticks begin in small steps, up to the first that is round: not all of those can have labels.
  const apart = ticks => {
    const least = Math.log(ticks.at(-1).value / ticks[0].value) / 15;
    const kept = new Set();
    let last = -Infinity;
    ticks.map(tick => tick.value).forEach(value => {
      if (Math.log(value) - last > least) {
        kept.add(value);
        last = Math.log(value);
      }
    });
    return kept;
  };

  // Over more than a power of ten 1, 2 and 5 are enough.
  const power = (value, _, ticks) =>
    (ticks.at(-1).value < 10 * ticks[0].value
      ? apart(ticks).has(value)
      : /^[125]e/.test(Number(value.toPrecision(3)).toExponential()))
      ? String(Number(value.toPrecision(3))) : '';

  const axis = (text, axes) => ({
    type: axes === 'logarithmic' ? 'logarithmic' : 'linear',
    title: { display: true, text, color: colour('--quiet') },
    ticks: {
      color: colour('--quiet'),
      includeBounds: false,
      ...(axes === 'logarithmic' ? { callback: power } : {}),
    },
    grid: { color: colour('--rule') },
  });

  const also = values => values.length === 0 ? {} : {
    suggestedMin: Math.min(...values),
    suggestedMax: Math.max(...values),
  };

  // A legend shows marks as they are drawn; the library's own has neither dots nor dashes.
  const mark = (curve, k) => {
    const image = document.createElement('canvas');
    image.width = 24;
    image.height = 10;
    const ink = image.getContext('2d');
    ink.fillStyle = paint(curve, k);
    ink.strokeStyle = paint(curve, k);
    if (hasLine(curve)) {
      ink.lineWidth = 2;
      ink.setLineDash(curve.mark === 'dashed' ? [6, 3] : []);
      ink.moveTo(0, 5);
      ink.lineTo(24, 5);
      ink.stroke();
    }
    for (const x of { dots: [4, 12, 20], points: [12] }[curve.mark] ?? []) {
      ink.beginPath();
      ink.arc(x, 5, radius[curve.mark], 0, 2 * Math.PI);
      ink.fill();
    }
    return image;
  };

  const legend = curves => ({
    color: colour('--ink'),
    usePointStyle: true,
    pointStyleWidth: 24,
    boxHeight: 6,
    generateLabels: chart => Chart.defaults.plugins.legend.labels.generateLabels(chart)
      .map(label => ({
        ...label,
        pointStyle: mark(curves[label.datasetIndex], label.datasetIndex),
      })),
  });

  const extent = (chart, key) => {
    const values = chart.curves.flatMap(curve => curve[key]).filter(value => value !== null);
    const low = values.reduce((a, b) => Math.min(a, b), Infinity);
    const high = values.reduce((a, b) => Math.max(a, b), -Infinity);
    return { middle: (low + high) / 2, length: 1.1 * (high - low) };
  };

  // Of a map, the axis that has room to spare shows more.
  const scaleAlike = ({ chart, drawn }) => {
    const { width, height } = drawn.chartArea;
    const x = extent(chart, 'x');
    const y = extent(chart, 'y');
    const unit = Math.max(x.length / width, y.length / height) || 1;
    const show = (of, pixels) => ({
      min: of.middle - unit * pixels / 2,
      max: of.middle + unit * pixels / 2,
    });
    Object.assign(drawn.options.scales.x, show(x, width));
    Object.assign(drawn.options.scales.y, show(y, height));
    drawn.update('none');
  };

  const draw = place => {
    const { chart, canvas } = place;
    const rescale = () => requestAnimationFrame(() => place.drawn && scaleAlike(place));
    place.drawn = new Chart(canvas, {
      type: 'scatter',
      data: { datasets: chart.curves.map(dataset) },
      options: {
        animation: false,
        maintainAspectRatio: false,
        onResize: chart.axes === 'map' ? rescale : undefined,
        scales: {
          x: axis(chart.x, chart.axes),
          y: { ...axis(chart.y, chart.axes), ...also(chart.alsoUp) },
        },
        plugins: { legend: { labels: legend(chart.curves) } },
      },
    });
    if (chart.axes === 'map') scaleAlike(place);
  };

  // What is folded away is drawn when it is opened.
  const drawVisible = () => places
    .filter(({ canvas, drawn }) => !drawn && !canvas.closest('details:not([open])'))
    .forEach(draw);

  drawVisible();
  document.querySelectorAll('details')
    .forEach(details => details.addEventListener('toggle', drawVisible));
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
    places.forEach(place => {
      place.drawn?.destroy();
      place.drawn = null;
    });
    drawVisible();
  });
})();
