<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="uk">
<context>
    <name>App::Property</name>
    <message>
        <source>Base</source>
        <translation>Основа</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Вимірювання</translation>
    </message>
    <message>
        <source>Further parts</source>
        <translation>Інші деталі</translation>
    </message>
    <message>
        <source>Earlier parts</source>
        <translation>Попередні деталі</translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation>Вимкнено</translation>
    </message>
    <message>
        <source>Earlier rounds</source>
        <translation>Попередні цикли</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>Номінал</translation>
    </message>
    <message>
        <source>Tool diameter</source>
        <translation>Діаметр інструмента</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Сторона</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Вирівнювання</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Прийняти</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Фільтр</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Метод</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Налагодження</translation>
    </message>
    <message>
        <source>Iterate</source>
        <translation>Повторювати</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Глибина</translation>
    </message>
    <message>
        <source>Next depth</source>
        <translation>Наступна глибина</translation>
    </message>
    <message>
        <source>Depth along</source>
        <translation>Глибина вздовж</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Передавальна функція</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Припуск</translation>
    </message>
    <message>
        <source>Leave stock</source>
        <translation>Залишити припуск</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Коефіцієнт</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Межа</translation>
    </message>
    <message>
        <source>Dead band</source>
        <translation>Зона нечутливості</translation>
    </message>
    <message>
        <source>Unmeasured share</source>
        <translation>Частка без точок</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Інструменти</translation>
    </message>
    <message>
        <source>Keep allowance</source>
        <translation>Зберігати припуск</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Допуск</translation>
    </message>
    <message>
        <source>Output moves</source>
        <translation>Вихідні рухи</translation>
    </message>
    <message>
        <source>Cutter compensation</source>
        <translation>Корекція на радіус</translation>
    </message>
    <message>
        <source>Deviation mean</source>
        <translation>Відхилення середнє</translation>
    </message>
    <message>
        <source>Deviation min</source>
        <translation>Відхилення найменше</translation>
    </message>
    <message>
        <source>Deviation max</source>
        <translation>Відхилення найбільше</translation>
    </message>
    <message>
        <source>Deviation height</source>
        <translation>Відхилення розмах</translation>
    </message>
    <message>
        <source>Deviation std</source>
        <translation>Відхилення станд.</translation>
    </message>
    <message>
        <source>Random std</source>
        <translation>Випадкове станд.</translation>
    </message>
    <message>
        <source>Largest correction</source>
        <translation>Найбільша корекція</translation>
    </message>
    <message>
        <source>Path error</source>
        <translation>Похибка траєкторії</translation>
    </message>
    <message>
        <source>Points used</source>
        <translation>Використані точки</translation>
    </message>
    <message>
        <source>Points rejected</source>
        <translation>Відкинуті точки</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Попередження</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Джерело</translation>
    </message>
    <message>
        <source>Digest</source>
        <translation>Контрольна сума</translation>
    </message>
    <message>
        <source>Corrected</source>
        <translation>Скориговано</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>Згладжене</translation>
    </message>
    <message>
        <source>Noted</source>
        <translation>Взято до відома</translation>
    </message>
    <message>
        <source>Cut path</source>
        <translation>Фрезерована траєкторія</translation>
    </message>
    <message>
        <source>The operation whose path is corrected</source>
        <translation>Операція, траєкторія якої коригується</translation>
    </message>
    <message>
        <source>The measured part; without one the path is made exact and nothing is corrected</source>
        <translation>Виміряна деталь; без неї траєкторія стає точною, але нічого не коригується</translation>
    </message>
    <message>
        <source>Measurements of further parts cut with the same path; deviations are averaged</source>
        <translation>Вимірювання інших деталей з тією самою траєкторією; відхилення усереднюються</translation>
    </message>
    <message>
        <source>Parts measured in earlier rounds, oldest first; the later ones were cut with their path</source>
        <translation>Деталі, виміряні в попередніх циклах, від найстарішої; пізніші фрезеровано за їхньою траєкторією</translation>
    </message>
    <message>
        <source>Measured parts that count for nothing</source>
        <translation>Виміряні деталі, що не враховуються</translation>
    </message>
    <message>
        <source>Number of parts and settings of each earlier round</source>
        <translation>Кількість деталей і параметри кожного попереднього циклу</translation>
    </message>
    <message>
        <source>Nominal profile; without one the operation's own geometry, or else its path</source>
        <translation>Номінальний контур; без нього геометрія операції, інакше її траєкторія</translation>
    </message>
    <message>
        <source>Diameter of the tool; 0 takes it from the tool controller</source>
        <translation>Діаметр інструмента; 0 бере його з контролера інструмента</translation>
    </message>
    <message>
        <source>Side of the contour on which the tool runs, along its direction</source>
        <translation>Сторона контуру, з якої йде інструмент за його напрямом</translation>
    </message>
    <message>
        <source>Best fit of the measured points before comparing: none, shift, rigid, or some of x, y, turn joined by +</source>
        <translation>Вирівнювання виміряних точок перед порівнянням: none, shift, rigid або деякі з x, y, turn, з'єднані знаком +</translation>
    </message>
    <message>
        <source>Findings about the measurement that are accepted by name</source>
        <translation>Зауваження щодо вимірювання, прийняті поіменно</translation>
    </message>
    <message>
        <source>What separates form from scatter: none, mean:5, mean:1,2,3,2,1, gauss:MM or auto</source>
        <translation>Що відділяє форму від розсіювання: none, mean:5, mean:1,2,3,2,1, gauss:MM або auto</translation>
    </message>
    <message>
        <source>How the path answers a deviation</source>
        <translation>Як траєкторія відповідає на відхилення</translation>
    </message>
    <message>
        <source>TOML file with tool, material, machine and stock, kept in the document</source>
        <translation>Файл TOML з інструментом, матеріалом, верстатом і заготовкою, зберігається в документі</translation>
    </message>
    <message>
        <source>Correct again in the model until the error to expect is at most this; 0: only once</source>
        <translation>Коригувати в моделі далі, доки очікувана похибка не перевищує цього; 0: лише раз</translation>
    </message>
    <message>
        <source>Depth in mm along the normal that the measured part was cut at; one, or one a part</source>
        <translation>Глибина в мм вздовж нормалі, з якою оброблено виміряну деталь; одна або по одній на деталь</translation>
    </message>
    <message>
        <source>Depth that the corrected path will cut; 0: that of the measured part</source>
        <translation>Глибина, яку зніматиме скоригована траєкторія; 0: як у виміряної деталі</translation>
    </message>
    <message>
        <source>How deviations are taken: along the normal, or along one axis</source>
        <translation>Як беруться відхилення: вздовж нормалі чи вздовж однієї осі</translation>
    </message>
    <message>
        <source>Smooth along the contour, one value, or one a point</source>
        <translation>Згладжена вздовж контуру, одне значення або по одному на точку</translation>
    </message>
    <message>
        <source>Stock in mm that the path of the measured part left on the nominal</source>
        <translation>Припуск у мм, який траєкторія виміряної деталі залишила на номіналі</translation>
    </message>
    <message>
        <source>Stock that the path leaves on the part: a first cut, before anything is measured</source>
        <translation>Припуск, який траєкторія залишає на деталі: перший прохід до вимірювання</translation>
    </message>
    <message>
        <source>Share of the deviation taken back</source>
        <translation>Частка відхилення, яка знімається</translation>
    </message>
    <message>
        <source>Largest correction; a larger one is refused</source>
        <translation>Найбільша корекція; більша відхиляється</translation>
    </message>
    <message>
        <source>Deviations up to this are left alone</source>
        <translation>Відхилення до цієї величини не чіпаються</translation>
    </message>
    <message>
        <source>Largest share of a contour without points near that is corrected all the same</source>
        <translation>Найбільша частка контуру без точок поблизу, яка все ж коригується</translation>
    </message>
    <message>
        <source>Diameters of other tools of the path, each as 3=16 or ROUGH=16</source>
        <translation>Діаметри інших інструментів траєкторії, кожен як 3=16 або ROUGH=16</translation>
    </message>
    <message>
        <source>Passes that rough along the contour are moved with it</source>
        <translation>Чорнові проходи вздовж контуру зміщуються разом із ним</translation>
    </message>
    <message>
        <source>Largest distance of the path from the exact one</source>
        <translation>Найбільша відстань траєкторії від точної</translation>
    </message>
    <message>
        <source>Moves of the corrected path: as the operation's, only lines, or arcs</source>
        <translation>Рухи скоригованої траєкторії: як в операції, лише відрізки, або дуги</translation>
    </message>
    <message>
        <source>What a path under G41 or G42 is: the contour itself, or the centre path</source>
        <translation>Чим є траєкторія під G41 або G42: самим контуром чи траєкторією центра</translation>
    </message>
    <message>
        <source>Mean deviation</source>
        <translation>Середнє відхилення</translation>
    </message>
    <message>
        <source>Least deviation</source>
        <translation>Найменше відхилення</translation>
    </message>
    <message>
        <source>Greatest deviation</source>
        <translation>Найбільше відхилення</translation>
    </message>
    <message>
        <source>Greatest less least</source>
        <translation>Найбільше мінус найменше</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>Стандартне відхилення</translation>
    </message>
    <message>
        <source>Standard deviation of what the filter takes for scatter</source>
        <translation>Стандартне відхилення того, що фільтр вважає розсіюванням</translation>
    </message>
    <message>
        <source>Largest distance of the path from the exact offset of the compensated profile</source>
        <translation>Найбільша відстань траєкторії від точної еквідистанти скоригованого профілю</translation>
    </message>
    <message>
        <source>Points left out</source>
        <translation>Вилучені точки</translation>
    </message>
    <message>
        <source>What to know</source>
        <translation>Що варто знати</translation>
    </message>
    <message>
        <source>Measured file of this correction</source>
        <translation>Файл вимірювань цієї корекції</translation>
    </message>
    <message>
        <source>SHA-256 of that file</source>
        <translation>SHA-256 цього файлу</translation>
    </message>
    <message>
        <source>When the correction was made</source>
        <translation>Коли зроблено корекцію</translation>
    </message>
    <message>
        <source>Deviation smoothed over the parts of a series, which is taken out in place of the measured one</source>
        <translation>Відхилення, згладжене за деталями серії, яке усувається замість виміряного</translation>
    </message>
    <message>
        <source>Warnings that were there when the user last looked at the correction</source>
        <translation>Попередження, що були, коли користувач востаннє переглядав корекцію</translation>
    </message>
    <message>
        <source>SHA-256 of the measurement, and of the operation's path when it came</source>
        <translation>SHA-256 вимірювання та траєкторії операції на той час</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Файл</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Точки</translation>
    </message>
    <message>
        <source>Ball radius</source>
        <translation>Радіус кульки</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Одиниця</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Формат</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>Відповідність</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Щуп</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Деталь</translation>
    </message>
    <message>
        <source>Work offset</source>
        <translation>Нуль деталі</translation>
    </message>
    <message>
        <source>Work offset given</source>
        <translation>Нуль деталі задано</translation>
    </message>
    <message>
        <source>Work rotation</source>
        <translation>Поворот</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Кількість</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Рівні</translation>
    </message>
    <message>
        <source>Has z</source>
        <translation>Має Z</translation>
    </message>
    <message>
        <source>The measured file, kept in the document</source>
        <translation>Файл вимірювань, зберігається в документі</translation>
    </message>
    <message>
        <source>What the coordinates are: points on the surface or centres of the probe's ball</source>
        <translation>Чим є координати: точками на поверхні чи центрами кульки щупа</translation>
    </message>
    <message>
        <source>Radius of the probe's ball where the points are centres; 0: as the file says</source>
        <translation>Радіус кульки щупа, якщо точки є центрами; 0: як каже файл</translation>
    </message>
    <message>
        <source>Unit of length in the file</source>
        <translation>Одиниця довжини у файлі</translation>
    </message>
    <message>
        <source>Format of the file; empty: by its content</source>
        <translation>Формат файлу; порожньо: за вмістом</translation>
    </message>
    <message>
        <source>TOML file that says what the columns of a text file are, kept in the document</source>
        <translation>Файл TOML, що пояснює стовпці текстового файлу, зберігається в документі</translation>
    </message>
    <message>
        <source>TOML file with the calibration of the probe, kept in the document</source>
        <translation>Файл TOML з калібруванням щупа, зберігається в документі</translation>
    </message>
    <message>
        <source>Which of several measured parts in the file, from 1; 0: it holds one</source>
        <translation>Яка з кількох деталей у файлі, від 1; 0: там одна</translation>
    </message>
    <message>
        <source>Origin of the work frame in the frame of the file, mm</source>
        <translation>Початок системи деталі в системі файлу, мм</translation>
    </message>
    <message>
        <source>The work offset holds; otherwise what the file says</source>
        <translation>Діє нуль деталі; інакше те, що каже файл</translation>
    </message>
    <message>
        <source>Turn of the work frame in the frame of the file, anticlockwise</source>
        <translation>Поворот системи деталі в системі файлу, проти годинникової стрілки</translation>
    </message>
    <message>
        <source>Name of the file</source>
        <translation>Назва файлу</translation>
    </message>
    <message>
        <source>SHA-256 of the file</source>
        <translation>SHA-256 файлу</translation>
    </message>
    <message>
        <source>Number of points</source>
        <translation>Кількість точок</translation>
    </message>
    <message>
        <source>Number of Z levels</source>
        <translation>Кількість рівнів Z</translation>
    </message>
    <message>
        <source>The file has a Z coordinate</source>
        <translation>Файл має координату Z</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Корекція</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Показано</translation>
    </message>
    <message>
        <source>Magnification</source>
        <translation>Збільшення</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Розмах</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>Степінь</translation>
    </message>
    <message>
        <source>Poles</source>
        <translation>Полюси</translation>
    </message>
    <message>
        <source>Contour length</source>
        <translation>Довжина контуру</translation>
    </message>
    <message>
        <source>The dressup whose compensated profile this is</source>
        <translation>Скоригована траєкторія, профілем якої це є</translation>
    </message>
    <message>
        <source>The profile to cut so that the part comes out right, the nominal one, the operation's path along it, the points as measured, those on the surface, or the deviations as lines along the normal</source>
        <translation>Профіль, який треба різати, щоб деталь вийшла правильною, номінальний, траєкторія операції вздовж нього, точки як виміряно, точки на поверхні або відхилення як лінії вздовж нормалі</translation>
    </message>
    <message>
        <source>So many times longer than they are the deviations are drawn</source>
        <translation>У стільки разів довшими рисуються відхилення</translation>
    </message>
    <message>
        <source>Z of the profile</source>
        <translation>Z профілю</translation>
    </message>
    <message>
        <source>Highest degree</source>
        <translation>Найвищий степінь</translation>
    </message>
    <message>
        <source>Number of poles</source>
        <translation>Кількість полюсів</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Довжина</translation>
    </message>
    <message>
        <source>Path tolerance</source>
        <translation>Допуск траєкторії</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>Пакет</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Ще раз</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Журнал</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Звіт</translation>
    </message>
    <message>
        <source>Jobs to run</source>
        <translation>Завдання до виконання</translation>
    </message>
    <message>
        <source>Also run what an earlier run has done</source>
        <translation>Також те, що вже виконано раніше</translation>
    </message>
    <message>
        <source>Journal of a series</source>
        <translation>Журнал серії</translation>
    </message>
    <message>
        <source>Directory for the report and the table of all parts</source>
        <translation>Каталог для звіту і таблиці всіх деталей</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Діалект</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Вихід</translation>
    </message>
    <message>
        <source>Points count</source>
        <translation>Кількість точок</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Крок</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Кривина</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Дотик</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Safe z</source>
        <translation>Безпечна Z</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Зазор</translation>
    </message>
    <message>
        <source>Overtravel</source>
        <translation>Перебіг</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Припуск</translation>
    </message>
    <message>
        <source>Free width</source>
        <translation>Вільна ширина</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Подача</translation>
    </message>
    <message>
        <source>Positioning feed</source>
        <translation>Подача позиціювання</translation>
    </message>
    <message>
        <source>Probe tool</source>
        <translation>Номер щупа</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Протокол</translation>
    </message>
    <message>
        <source>Control that runs it</source>
        <translation>ЧПК, на якому виконується</translation>
    </message>
    <message>
        <source>Measuring program to write</source>
        <translation>Вимірювальна програма для запису</translation>
    </message>
    <message>
        <source>Radius at which the probe triggers, as calibrated</source>
        <translation>Радіус спрацювання щупа за калібруванням</translation>
    </message>
    <message>
        <source>Number of points; 0: by their distance</source>
        <translation>Кількість точок; 0: за їх кроком</translation>
    </message>
    <message>
        <source>Distance of points along the contour</source>
        <translation>Відстань між точками вздовж контуру</translation>
    </message>
    <message>
        <source>Denser where the contour bends</source>
        <translation>Густіше там, де контур згинається</translation>
    </message>
    <message>
        <source>Along an axis where the slope allows it, always along an axis, or along the normal</source>
        <translation>Вздовж осі, де дозволяє нахил, завжди вздовж осі або вздовж нормалі</translation>
    </message>
    <message>
        <source>Height to measure at</source>
        <translation>Висота вимірювання</translation>
    </message>
    <message>
        <source>Height at which the probe passes over everything</source>
        <translation>Висота, на якій щуп проходить над усім</translation>
    </message>
    <message>
        <source>Distance from which a touch begins</source>
        <translation>Відстань, з якої починається дотик</translation>
    </message>
    <message>
        <source>How far behind the surface a touch gives up</source>
        <translation>Як далеко за поверхнею дотик припиняється</translation>
    </message>
    <message>
        <source>Stock that is still on the contour</source>
        <translation>Припуск, який ще лишився на контурі</translation>
    </message>
    <message>
        <source>How far beside the contour it is free; 0: everywhere</source>
        <translation>Наскільки вільно біля контуру; 0: усюди</translation>
    </message>
    <message>
        <source>Contour to measure, where it is not the operation's own</source>
        <translation>Контур для вимірювання, якщо він не з операції</translation>
    </message>
    <message>
        <source>Feed of the touch, mm/min</source>
        <translation>Подача дотику, мм/хв</translation>
    </message>
    <message>
        <source>Feed of moves at measuring height, mm/min</source>
        <translation>Подача рухів на висоті вимірювання, мм/хв</translation>
    </message>
    <message>
        <source>Number of the probe in the magazine; 0: it is in use</source>
        <translation>Номер щупа в магазині; 0: він уже встановлений</translation>
    </message>
    <message>
        <source>Name of the file the control writes; empty: as usual</source>
        <translation>Назва файлу, який пише ЧПК; порожньо: звичайна</translation>
    </message>
    <message>
        <source>Show picture</source>
        <translation>Показати зображення</translation>
    </message>
    <message>
        <source>Automatic magnification</source>
        <translation>Автоматичне збільшення</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>Верхнє відхилення</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>Нижнє відхилення</translation>
    </message>
    <message>
        <source>Material left</source>
        <translation>Залишений матеріал</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Стінка</translation>
    </message>
    <message>
        <source>Whiskers</source>
        <translation>Лінії відхилень</translation>
    </message>
    <message>
        <source>Band</source>
        <translation>Смуга</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Профілі</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Траєкторії</translation>
    </message>
    <message>
        <source>Rejected points</source>
        <translation>Відкинуті точки</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Легенда</translation>
    </message>
    <message>
        <source>Show the deviations in the 3-D view</source>
        <translation>Показати відхилення у тривимірному вигляді</translation>
    </message>
    <message>
        <source>Deviations and the part's size decide how much larger deviations are drawn</source>
        <translation>Відхилення й розмір деталі визначають, наскільки більшими рисуються відхилення</translation>
    </message>
    <message>
        <source>So many times longer than they are deviations and differences are drawn, as far as it turns no contour inside out</source>
        <translation>У стільки разів довшими рисуються відхилення й різниці, доки це не вивертає контуру</translation>
    </message>
    <message>
        <source>Larger deviations are out of tolerance: too much material is left</source>
        <translation>Більші відхилення поза допуском: залишено забагато матеріалу</translation>
    </message>
    <message>
        <source>Smaller deviations are out of tolerance: too much is cut away</source>
        <translation>Менші відхилення поза допуском: зрізано забагато</translation>
    </message>
    <message>
        <source>Colour of material left; measuring machines' programs show it red</source>
        <translation>Колір залишеного матеріалу; програми вимірювальних машин показують його червоним</translation>
    </message>
    <message>
        <source>Show the deviation as the colour of the wall itself</source>
        <translation>Показати відхилення кольором самої стінки</translation>
    </message>
    <message>
        <source>Show each deviation as a line</source>
        <translation>Показати кожне відхилення лінією</translation>
    </message>
    <message>
        <source>Show the tolerance band</source>
        <translation>Показати смугу допуску</translation>
    </message>
    <message>
        <source>Show nominal and compensated profile</source>
        <translation>Показати номінальний і скоригований профілі</translation>
    </message>
    <message>
        <source>Show the path before and after</source>
        <translation>Показати траєкторію до і після</translation>
    </message>
    <message>
        <source>Mark points that are left out</source>
        <translation>Позначити вилучені точки</translation>
    </message>
    <message>
        <source>Show what the colours mean</source>
        <translation>Показати, що означають кольори</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Програма</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Виміряно</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Частка</translation>
    </message>
    <message>
        <source>NC program that cut the measured part</source>
        <translation>Програма ЧПК, якою оброблено виміряну деталь</translation>
    </message>
    <message>
        <source>Diameter of the cutter</source>
        <translation>Діаметр фрези</translation>
    </message>
    <message>
        <source>Contour the part should have: a drawing, or the first program; empty: the program's</source>
        <translation>Контур, який має бути: креслення або перша програма; порожньо: з програми</translation>
    </message>
    <message>
        <source>Measured points, one file a part; deviations of several parts are averaged</source>
        <translation>Виміряні точки, один файл на деталь; відхилення кількох деталей усереднюються</translation>
    </message>
    <message>
        <source>Moves of the corrected program: as the program's, only lines, arcs, or NURBS</source>
        <translation>Рухи скоригованої програми: як у програмі, лише відрізки, дуги або NURBS</translation>
    </message>
    <message>
        <source>Corrected program to write</source>
        <translation>Скоригована програма для запису</translation>
    </message>
    <message>
        <source>Directory for the report; empty: none</source>
        <translation>Каталог для звіту; порожньо: без звіту</translation>
    </message>
    <message>
        <source>Record the part in the journal of its series</source>
        <translation>Записати деталь у журнал її серії</translation>
    </message>
    <message>
        <source>NC program that finishes the part</source>
        <translation>Програма ЧПК, що завершує деталь</translation>
    </message>
    <message>
        <source>Whole allowance over the finished contour</source>
        <translation>Увесь припуск над готовим контуром</translation>
    </message>
    <message>
        <source>Share of the allowance that the first cut takes</source>
        <translation>Частка припуску, яку знімає перший прохід</translation>
    </message>
    <message>
        <source>Program of the first cut</source>
        <translation>Програма першого проходу</translation>
    </message>
    <message>
        <source>Tool, material, machine and stock</source>
        <translation>Інструмент, матеріал, верстат і заготовка</translation>
    </message>
    <message>
        <source>Errors and the part's size decide how much larger errors are drawn</source>
        <translation>Похибки й розмір деталі визначають, наскільки більшими рисуються похибки</translation>
    </message>
    <message>
        <source>So many times larger errors are drawn</source>
        <translation>У стільки разів більшими рисуються похибки</translation>
    </message>
    <message>
        <source>Directory for the report with all signals</source>
        <translation>Каталог для звіту з усіма сигналами</translation>
    </message>
</context>
<context>
    <name>Millcorr</name>
    <message>
        <source>auto</source>
        <translation>автоматично</translation>
    </message>
    <message>
        <source>left</source>
        <translation>ліворуч</translation>
    </message>
    <message>
        <source>right</source>
        <translation>праворуч</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>дзеркально</translation>
    </message>
    <message>
        <source>transfer</source>
        <translation>передача</translation>
    </message>
    <message>
        <source>combined</source>
        <translation>комбінований</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>прогноз</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>нормаль</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>згладжена</translation>
    </message>
    <message>
        <source>one</source>
        <translation>одна</translation>
    </message>
    <message>
        <source>points</source>
        <translation>точки</translation>
    </message>
    <message>
        <source>keep</source>
        <translation>зберегти</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>відрізки</translation>
    </message>
    <message>
        <source>arcs</source>
        <translation>дуги</translation>
    </message>
    <message>
        <source>nurbs</source>
        <translation>NURBS</translation>
    </message>
    <message>
        <source>contour</source>
        <translation>контур</translation>
    </message>
    <message>
        <source>wear</source>
        <translation>знос</translation>
    </message>
    <message>
        <source>the tool controller's</source>
        <translation>контролера інструмента</translation>
    </message>
    <message>
        <source>only once</source>
        <translation>лише раз</translation>
    </message>
    <message>
        <source>that of the measured part</source>
        <translation>як у виміряної деталі</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>контактні точки</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>центри</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>вісь</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>мм</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>дюйм</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>як каже файл</translation>
    </message>
    <message>
        <source>the only one</source>
        <translation>єдина</translation>
    </message>
    <message>
        <source>µm</source>
        <translation>мкм</translation>
    </message>
    <message>
        <source>in</source>
        <translation>дюйм</translation>
    </message>
    <message>
        <source>thou</source>
        <translation>мілідюйм</translation>
    </message>
    <message>
        <source>Reading points</source>
        <translation>Читання точок</translation>
    </message>
    <message>
        <source>Reading the program</source>
        <translation>Читання програми</translation>
    </message>
    <message>
        <source>Best fit</source>
        <translation>Вирівнювання</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>Відхилення</translation>
    </message>
    <message>
        <source>Looking for doubts</source>
        <translation>Пошук сумнівів</translation>
    </message>
    <message>
        <source>Separating form from scatter</source>
        <translation>Відділення форми від розсіювання</translation>
    </message>
    <message>
        <source>Cutting in the model</source>
        <translation>Різання в моделі</translation>
    </message>
    <message>
        <source>Laying and proving the path</source>
        <translation>Побудова і перевірка траєкторії</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Рисування</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Завдання</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Стан</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Час</translation>
    </message>
    <message>
        <source>Told</source>
        <translation>Повідомлення</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Серія</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Деталь</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Виміряно</translation>
    </message>
    <message>
        <source>Mean, {}</source>
        <translation>Середнє, {}</translation>
    </message>
    <message>
        <source>Std. deviation, {}</source>
        <translation>Станд. відхилення, {}</translation>
    </message>
    <message>
        <source>Height, {}</source>
        <translation>Розмах, {}</translation>
    </message>
    <message>
        <source>Correction, {}</source>
        <translation>Корекція, {}</translation>
    </message>
    <message>
        <source>Decision</source>
        <translation>Рішення</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Запустити</translation>
    </message>
    <message>
        <source>Write report</source>
        <translation>Записати звіт</translation>
    </message>
    <message>
        <source>Batches (*.toml);;All files (*)</source>
        <translation>Пакети (*.toml);;Усі файли (*)</translation>
    </message>
    <message>
        <source>Journals (*.journal);;All files (*)</source>
        <translation>Журнали (*.journal);;Усі файли (*)</translation>
    </message>
    <message>
        <source>done before</source>
        <translation>виконано раніше</translation>
    </message>
    <message>
        <source>done</source>
        <translation>виконано</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>Пакет</translation>
    </message>
    <message>
        <source>failed ({})</source>
        <translation>не вдалося ({})</translation>
    </message>
    <message>
        <source>History of parts</source>
        <translation>Історія деталей</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Журнал</translation>
    </message>
    <message>
        <source>Show as plot</source>
        <translation>Показати графіком</translation>
    </message>
    <message>
        <source>{} of {} jobs</source>
        <translation>{} з {} завдань</translation>
    </message>
    <message>
        <source>Stopped; run it again to go on</source>
        <translation>Зупинено; запустіть ще раз, щоб продовжити</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>чекає</translation>
    </message>
    <message>
        <source>the open task ended: OK or Cancel</source>
        <translation>завершити відкрите завдання: OK або Скасувати</translation>
    </message>
    <message>
        <source>Needs:</source>
        <translation>Потрібно:</translation>
    </message>
    <message>
        <source>the operation's own contour</source>
        <translation>власний контур операції</translation>
    </message>
    <message>
        <source>Compensated toolpath</source>
        <translation>Скоригована траєкторія</translation>
    </message>
    <message>
        <source>Measured parts</source>
        <translation>Виміряні деталі</translation>
    </message>
    <message>
        <source>Measured part</source>
        <translation>Виміряна деталь</translation>
    </message>
    <message>
        <source>Oldest first. Each part was cut with the path that those before it gave; what is not ticked counts for nothing.</source>
        <translation>Від найстарішої. Кожну деталь фрезеровано за траєкторією, яку дали попередні; непозначене не враховується.</translation>
    </message>
    <message>
        <source>&amp;Import file…</source>
        <translation>&amp;Імпортувати файл…</translation>
    </message>
    <message>
        <source>Point at a whisker to see its point; click to keep it.</source>
        <translation>Наведіть на лінію, щоб побачити її точку; клацніть, щоб залишити.</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Корекція</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Метод</translation>
    </message>
    <message>
        <source>More settings</source>
        <translation>Додаткові налаштування</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Зображення</translation>
    </message>
    <message>
        <source>none: only make the path exact</source>
        <translation>немає: лише уточнити траєкторію</translation>
    </message>
    <message>
        <source>no further part</source>
        <translation>жодної нової деталі</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Додати</translation>
    </message>
    <message>
        <source>It is right as it is</source>
        <translation>Так правильно</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>не число</translation>
    </message>
    <message>
        <source>points on the surface (contact)</source>
        <translation>точки на поверхні (контакт)</translation>
    </message>
    <message>
        <source>centres of the probe's ball</source>
        <translation>центри кульки щупа</translation>
    </message>
    <message>
        <source>ball centres that the control shifted along an axis</source>
        <translation>центри кульки, які ЧПК змістило вздовж осі</translation>
    </message>
    <message>
        <source>mirror: take back what was measured</source>
        <translation>дзеркально: зняти те, що виміряно</translation>
    </message>
    <message>
        <source>transfer: by how the machine gives way</source>
        <translation>передача: за тим, як піддається верстат</translation>
    </message>
    <message>
        <source>combined: one or two touches, and a model of the machine</source>
        <translation>комбінований: один або два дотики і модель верстата</translation>
    </message>
    <message>
        <source>predicted: by the model alone, before anything is measured</source>
        <translation>прогноз: лише за моделлю, до будь-яких вимірювань</translation>
    </message>
    <message>
        <source>as the operation's</source>
        <translation>як в операції</translation>
    </message>
    <message>
        <source>blue, undercut red</source>
        <translation>синій, підріз червоний</translation>
    </message>
    <message>
        <source>red, undercut blue</source>
        <translation>червоний, підріз синій</translation>
    </message>
    <message>
        <source>none; several separated by ;</source>
        <translation>немає; кілька через ;</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>виміряно</translation>
    </message>
    <message>
        <source>expected</source>
        <translation>очікується</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Середнє</translation>
    </message>
    <message>
        <source>Mean deviation; positive where material is left</source>
        <translation>Середнє відхилення; додатне там, де лишився матеріал</translation>
    </message>
    <message>
        <source>Least</source>
        <translation>Найменше</translation>
    </message>
    <message>
        <source>Deepest undercut</source>
        <translation>Найглибший підріз</translation>
    </message>
    <message>
        <source>Greatest</source>
        <translation>Найбільше</translation>
    </message>
    <message>
        <source>Most material left</source>
        <translation>Найбільше залишеного матеріалу</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Розмах</translation>
    </message>
    <message>
        <source>Greatest less least</source>
        <translation>Найбільше мінус найменше</translation>
    </message>
    <message>
        <source>Std. dev.</source>
        <translation>Станд. відх.</translation>
    </message>
    <message>
        <source>Spread of deviations about their mean</source>
        <translation>Розкид відхилень навколо середнього</translation>
    </message>
    <message>
        <source>Scatter</source>
        <translation>Розсіювання</translation>
    </message>
    <message>
        <source>Standard deviation of what does not repeat and is therefore not corrected</source>
        <translation>Стандартне відхилення того, що не повторюється і тому не коригується</translation>
    </message>
    <message>
        <source>Largest correction</source>
        <translation>Найбільша корекція</translation>
    </message>
    <message>
        <source>Farthest that the profile to cut lies from the nominal</source>
        <translation>Як далеко профіль для різання відходить від номіналу</translation>
    </message>
    <message>
        <source>Path error before</source>
        <translation>Похибка траєкторії до</translation>
    </message>
    <message>
        <source>How far the operation's own path is off the exact one</source>
        <translation>Наскільки траєкторія операції відходить від точної</translation>
    </message>
    <message>
        <source>Path error after</source>
        <translation>Похибка траєкторії після</translation>
    </message>
    <message>
        <source>How far the corrected path is off the exact one, read back from the finished path</source>
        <translation>Наскільки скоригована траєкторія відходить від точної, прочитано з готової траєкторії</translation>
    </message>
    <message>
        <source>Points used</source>
        <translation>Використані точки</translation>
    </message>
    <message>
        <source>Points used, of those in the file</source>
        <translation>Використані точки з тих, що у файлі</translation>
    </message>
    <message>
        <source>Points left out</source>
        <translation>Вилучені точки</translation>
    </message>
    <message>
        <source>Each is marked in the picture, with its reason</source>
        <translation>Кожну позначено на зображенні, з причиною</translation>
    </message>
    <message>
        <source>Settings (*.toml);;All files (*)</source>
        <translation>Налаштування (*.toml);;Усі файли (*)</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Вибрати</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>не використано</translation>
    </message>
    <message>
        <source>no file yet</source>
        <translation>ще немає файлу</translation>
    </message>
    <message>
        <source>Meaning of column {}</source>
        <translation>Значення стовпця {}</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Запис</translation>
    </message>
    <message>
        <source>Stopped; nothing was written</source>
        <translation>Зупинено; нічого не записано</translation>
    </message>
    <message>
        <source>Needs: {}</source>
        <translation>Потрібно: {}</translation>
    </message>
    <message>
        <source>More in the documentation</source>
        <translation>Докладніше в документації</translation>
    </message>
    <message>
        <source>Millcorr help</source>
        <translation>Довідка Millcorr</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Назад</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Зміст</translation>
    </message>
    <message>
        <source>Import measurement</source>
        <translation>Імпорт вимірювання</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Файл</translation>
    </message>
    <message>
        <source>file of a CMM, a probe log, or a table of points</source>
        <translation>файл КВМ, журнал щупа або таблиця точок</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Огляд…</translation>
    </message>
    <message>
        <source>&amp;More</source>
        <translation>&amp;Більше</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Імпортувати</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Скасувати</translation>
    </message>
    <message>
        <source>Origin of the work frame in the file's, mm</source>
        <translation>Початок системи деталі в системі файлу, мм</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Виміряні точки</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Усі файли (*)</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Читання</translation>
    </message>
    <message>
        <source>by its content</source>
        <translation>за вмістом</translation>
    </message>
    <message>
        <source>Points: {}, heights: {}. {} {}. Format: {}, unit in the file: {}</source>
        <translation>Точки: {}, рівні: {}. {} {}. Формат: {}, одиниця у файлі: {}</translation>
    </message>
    <message>
        <source>Not imported, see the report view</source>
        <translation>Не імпортовано, див. вікно звіту</translation>
    </message>
    <message>
        <source>nominal profile</source>
        <translation>номінальний профіль</translation>
    </message>
    <message>
        <source>profile to cut</source>
        <translation>профіль для різання</translation>
    </message>
    <message>
        <source>tolerance band</source>
        <translation>смуга допуску</translation>
    </message>
    <message>
        <source>path before</source>
        <translation>траєкторія до</translation>
    </message>
    <message>
        <source>corrected path</source>
        <translation>скоригована траєкторія</translation>
    </message>
    <message>
        <source>points left out</source>
        <translation>вилучені точки</translation>
    </message>
    <message>
        <source>in tolerance</source>
        <translation>у допуску</translation>
    </message>
    <message>
        <source>material left</source>
        <translation>залишок матеріалу</translation>
    </message>
    <message>
        <source>undercut</source>
        <translation>підріз</translation>
    </message>
    <message>
        <source>Deviations {}:1</source>
        <translation>Відхилення {}:1</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>автоматично</translation>
    </message>
    <message>
        <source>no points near</source>
        <translation>поблизу немає точок</translation>
    </message>
    <message>
        <source>the largest possible</source>
        <translation>найбільше можливе</translation>
    </message>
    <message>
        <source>(the largest of every {})</source>
        <translation>(найбільші з кожних {})</translation>
    </message>
    <message>
        <source>Drawn at {:.4g}:1: more would turn the contour inside out.</source>
        <translation>Рисується {:.4g}:1: більше вивернуло б контур.</translation>
    </message>
    <message>
        <source>Run in LinuxCNC's own interpreter. Moves between touches are unprotected.</source>
        <translation>Виконано у власному інтерпретаторі LinuxCNC. Рухи між дотиками не захищені.</translation>
    </message>
    <message>
        <source>Run in LinuxCNC's own interpreter. Moves between touches stop at contact. Prefer it.</source>
        <translation>Виконано у власному інтерпретаторі LinuxCNC. Рухи між дотиками зупиняються при контакті. Кращий варіант.</translation>
    </message>
    <message>
        <source>Run in an interpreter written after GRBL's documentation. Moves between touches are unprotected.</source>
        <translation>Виконано в інтерпретаторі, написаному за документацією GRBL. Рухи між дотиками не захищені.</translation>
    </message>
    <message>
        <source>Run in an interpreter written after Renishaw's description of its cycles; result variables compared with public tables.</source>
        <translation>Виконано в інтерпретаторі за описом циклів Renishaw; змінні результатів звірено з відкритими таблицями.</translation>
    </message>
    <message>
        <source>Run in an interpreter written after public descriptions. No manual with the names of the arguments was at hand: compare with yours.</source>
        <translation>Виконано в інтерпретаторі за відкритими описами. Посібника з назвами аргументів не було: звірте зі своїм.</translation>
    </message>
    <message>
        <source>Run in an interpreter written after the description of TCH PROBE cycle 3.</source>
        <translation>Виконано в інтерпретаторі за описом циклу 3 TCH PROBE.</translation>
    </message>
    <message>
        <source>Run in an interpreter written after the programming manual of MEAS.</source>
        <translation>Виконано в інтерпретаторі за посібником з програмування MEAS.</translation>
    </message>
    <message>
        <source>Write program</source>
        <translation>Записати програму</translation>
    </message>
    <message>
        <source>by their distance</source>
        <translation>за їхньою відстанню</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>усюди</translation>
    </message>
    <message>
        <source>it is in use</source>
        <translation>він уже у шпинделі</translation>
    </message>
    <message>
        <source>Measuring program</source>
        <translation>Вимірювальна програма</translation>
    </message>
    <message>
        <source>No program of millcorr has run on a real machine. Run the first one above the part, then with the feed override low and a hand on feed hold.</source>
        <translation>Жодна програма millcorr не виконувалась на справжньому верстаті. Першу виконайте над деталлю, потім з малою подачею і рукою на зупинці подачі.</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Система ЧПК</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>Простір</translation>
    </message>
    <message>
        <source>Probe and points on {}</source>
        <translation>Щуп і точки на {}</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>одиниця</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>радіус</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>система координат</translation>
    </message>
    <message>
        <source>stated</source>
        <translation>вказано у файлі</translation>
    </message>
    <message>
        <source>said</source>
        <translation>задано вами</translation>
    </message>
    <message>
        <source>inferred</source>
        <translation>виведено</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>припущено</translation>
    </message>
    <message>
        <source>the file does not say</source>
        <translation>у файлі цього не сказано</translation>
    </message>
    <message>
        <source>the work frame; the file does not say</source>
        <translation>система деталі; у файлі цього не сказано</translation>
    </message>
    <message>
        <source>three decimals, as GRBL prints mm</source>
        <translation>три знаки після коми, як GRBL виводить мм</translation>
    </message>
    <message>
        <source>places farther out than such machines go in inches</source>
        <translation>точки далі, ніж такі верстати їздять у дюймах</translation>
    </message>
    <message>
        <source>no METRIC in the first line, which PC-DMIS takes for inch</source>
        <translation>немає METRIC у першому рядку, що PC-DMIS вважає дюймами</translation>
    </message>
    <message>
        <source>the profile values stored in the file</source>
        <translation>значення профілю, збережені у файлі</translation>
    </message>
    <message>
        <source>the file's other points</source>
        <translation>інші точки файлу</translation>
    </message>
    <message>
        <source>Millcorr needs Python packages that FreeCAD's Python does not have: {}.

They can be installed into {}, for FreeCAD alone, from the network.</source>
        <translation>Millcorr потребує пакетів Python, яких немає в Python програми FreeCAD: {}.

Їх можна встановити з мережі в {}, лише для FreeCAD.</translation>
    </message>
    <message>
        <source>They could not be installed: {}

In a terminal, this does the same:
{}</source>
        <translation>Їх не вдалося встановити: {}

У терміналі те саме робить:
{}</translation>
    </message>
    <message>
        <source>Python packages, which a dialog offers to install: {}</source>
        <translation>пакети Python, які пропонує встановити вікно: {}</translation>
    </message>
    <message>
        <source>Install</source>
        <translation>Встановити</translation>
    </message>
    <message>
        <source>Installing…</source>
        <translation>Встановлення…</translation>
    </message>
    <message>
        <source>Installed. Start FreeCAD again to use them.</source>
        <translation>Встановлено. Запустіть FreeCAD знову, щоб їх використати.</translation>
    </message>
    <message>
        <source>On Debian and Ubuntu pip comes with: apt install python3-pip</source>
        <translation>У Debian та Ubuntu pip дає команда: apt install python3-pip</translation>
    </message>
    <message>
        <source>Stopped: change a setting to compute again</source>
        <translation>Зупинено: змініть налаштування, щоб обчислити знову</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Зупинити</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Обчислення</translation>
    </message>
    <message>
        <source>Internal error, see the report view</source>
        <translation>Внутрішня помилка, див. вікно звіту</translation>
    </message>
    <message>
        <source>Close the open task first</source>
        <translation>Спершу закрийте відкрите завдання</translation>
    </message>
    <message>
        <source>Not possible yet: see {}</source>
        <translation>Поки неможливо: див. {}</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>синій</translation>
    </message>
    <message>
        <source>red</source>
        <translation>червоний</translation>
    </message>
    <message>
        <source>expected next</source>
        <translation>очікується далі</translation>
    </message>
    <message>
        <source>range of the points</source>
        <translation>діапазон точок</translation>
    </message>
    <message>
        <source>mean and standard deviation</source>
        <translation>середнє і стандартне відхилення</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>межі</translation>
    </message>
    <message>
        <source>program corrected</source>
        <translation>програму скориговано</translation>
    </message>
    <message>
        <source>outlier</source>
        <translation>викид</translation>
    </message>
    <message>
        <source>normal law of the scatter</source>
        <translation>нормальний закон розсіювання</translation>
    </message>
    <message>
        <source>part</source>
        <translation>деталь</translation>
    </message>
    <message>
        <source>arc length s, {}</source>
        <translation>довжина дуги s, {}</translation>
    </message>
    <message>
        <source>uncertainty, k = {:g}</source>
        <translation>невизначеність, k = {:g}</translation>
    </message>
    <message>
        <source>determined part</source>
        <translation>детермінована частина</translation>
    </message>
    <message>
        <source>form, root mean square</source>
        <translation>форма, середнє квадратичне</translation>
    </message>
    <message>
        <source>smoothed, largest</source>
        <translation>згладжене, найбільше</translation>
    </message>
    <message>
        <source>deviation, {}</source>
        <translation>відхилення, {}</translation>
    </message>
    <message>
        <source>Click at a place of the picture or the plot to see its line of the file.</source>
        <translation>Клацніть місце картини або графіка, щоб побачити його рядок файла.</translation>
    </message>
    <message>
        <source>The measured file is no plain text.</source>
        <translation>Файл вимірювання не є простим текстом.</translation>
    </message>
    <message>
        <source>s {0:.{1}f} {2}: measured {3} {5}, expected next {4} {5}</source>
        <translation>s {0:.{1}f} {2}: виміряно {3} {5}, очікується далі {4} {5}</translation>
    </message>
    <message>
        <source>Millcorr plots</source>
        <translation>Графіки Millcorr</translation>
    </message>
    <message>
        <source>Linked to the 3-D view</source>
        <translation>Зв'язано з тривимірним виглядом</translation>
    </message>
    <message>
        <source>What is pointed at in the plot shows in the 3-D view and the other way round; the view follows the zoom of the plot, the plot that of the view</source>
        <translation>На що вказано на графіку, видно у тривимірному вигляді, і навпаки; вигляд іде за масштабом графіка, графік за масштабом вигляду</translation>
    </message>
    <message>
        <source>Measured file</source>
        <translation>Файл вимірювання</translation>
    </message>
    <message>
        <source>Select a compensated toolpath</source>
        <translation>Виберіть скориговану траєкторію</translation>
    </message>
    <message>
        <source>A journal's parts are plotted from the window History of parts</source>
        <translation>Деталі журналу рисує вікно «Історія деталей»</translation>
    </message>
    <message>
        <source>Along the contour</source>
        <translation>Вздовж контуру</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Розподіл</translation>
    </message>
    <message>
        <source>The journal has no part yet</source>
        <translation>У журналі ще немає деталей</translation>
    </message>
    <message>
        <source>{}, parts: {}</source>
        <translation>{}, деталей: {}</translation>
    </message>
    <message>
        <source>{}: nothing was measured</source>
        <translation>{}: нічого не виміряно</translation>
    </message>
    <message>
        <source>NC programs (*.nc *.ngc *.tap *.gcode *.cnc *.mpf *.h *.txt);;All files (*)</source>
        <translation>Програми ЧПК (*.nc *.ngc *.tap *.gcode *.cnc *.mpf *.h *.txt);;Усі файли (*)</translation>
    </message>
    <message>
        <source>Contours (*.step *.stp *.iges *.igs *.brep *.dxf *.json *.nc *.ngc *.tap *.gcode *.cnc *.mpf);;All files (*)</source>
        <translation>Контури (*.step *.stp *.iges *.igs *.brep *.dxf *.json *.nc *.ngc *.tap *.gcode *.cnc *.mpf);;Усі файли (*)</translation>
    </message>
    <message>
        <source>Correct NC program file</source>
        <translation>Коригувати файл програми ЧПК</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Програма</translation>
    </message>
    <message>
        <source>How the file is read</source>
        <translation>Як читається файл</translation>
    </message>
    <message>
        <source>What is written</source>
        <translation>Що записується</translation>
    </message>
    <message>
        <source>Split allowance</source>
        <translation>Поділити припуск</translation>
    </message>
    <message>
        <source>The first cut leaves a part of the allowance. Measure it, then correct the program that finishes the part with the method “transfer”: the part itself has shown how far the machine yields.</source>
        <translation>Перший прохід залишає частину припуску. Виміряйте її, потім скоригуйте програму, що завершує деталь, методом «передача»: деталь сама показала, наскільки піддається верстат.</translation>
    </message>
    <message>
        <source>The program of the first cut is written</source>
        <translation>Програму першого проходу записано</translation>
    </message>
    <message>
        <source>Deviations, {}</source>
        <translation>Відхилення, {}</translation>
    </message>
    <message>
        <source>Set {} to {}</source>
        <translation>Встановити {}: {}</translation>
    </message>
    <message>
        <source>Go to {}</source>
        <translation>Перейти до {}</translation>
    </message>
    <message>
        <source>Switch on {}</source>
        <translation>Увімкнути {}</translation>
    </message>
    <message>
        <source>an operation selected in the tree</source>
        <translation>операція, вибрана в дереві</translation>
    </message>
    <message>
        <source>a compensated toolpath: make one first</source>
        <translation>скоригована траєкторія: спершу створіть її</translation>
    </message>
    <message>
        <source>an open document</source>
        <translation>відкритий документ</translation>
    </message>
    <message>
        <source>a job with an operation, such as a Profile</source>
        <translation>завдання з операцією, наприклад Profile</translation>
    </message>
    <message>
        <source>an operation that stands in a job, without a dressup over it: select the dressup</source>
        <translation>операція в завданні без накладення над нею: виберіть накладення</translation>
    </message>
    <message>
        <source>a compensated toolpath selected in the tree</source>
        <translation>скоригована траєкторія, вибрана в дереві</translation>
    </message>
    <message>
        <source>a compensated toolpath with a measured part</source>
        <translation>скоригована траєкторія з виміряною деталлю</translation>
    </message>
    <message>
        <source>a Profile operation with a path, selected in the tree</source>
        <translation>операція Profile з траєкторією, вибрана в дереві</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Моделювання</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>час, с</translation>
    </message>
    <message>
        <source>force</source>
        <translation>сила</translation>
    </message>
    <message>
        <source>engaged arc</source>
        <translation>кут контакту</translation>
    </message>
    <message>
        <source>feed</source>
        <translation>подача</translation>
    </message>
    <message>
        <source>deflection</source>
        <translation>прогин</translation>
    </message>
    <message>
        <source>Setups (*.toml);;All files (*)</source>
        <translation>Налагодження (*.toml);;Усі файли (*)</translation>
    </message>
    <message>
        <source>Name the setup: tool, material, machine and stock, as a TOML file.</source>
        <translation>Вкажіть налагодження: інструмент, матеріал, верстат і заготовку, як файл TOML.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Відтворити</translation>
    </message>
    <message>
        <source>So many times faster than the machine</source>
        <translation>У стільки разів швидше за верстат</translation>
    </message>
    <message>
        <source>Largest predicted error {} {}</source>
        <translation>Найбільша прогнозована похибка {} {}</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Пауза</translation>
    </message>
    <message>
        <source>{:.2f} s, line {}: </source>
        <translation>{:.2f} с, рядок {}: </translation>
    </message>
    <message>
        <source>, corrected {} {}</source>
        <translation>, скориговано {} {}</translation>
    </message>
    <message>
        <source>&lt;span style='color:#888'&gt;—&lt;/span&gt; commanded path, &lt;span style='color:#c00'&gt;—&lt;/span&gt; machined contour, &lt;span style='color:#2e9a1c'&gt;—&lt;/span&gt; corrected contour, errors {:g}:1</source>
        <translation>&lt;span style='color:#888'&gt;—&lt;/span&gt; задана траєкторія, &lt;span style='color:#c00'&gt;—&lt;/span&gt; оброблений контур, &lt;span style='color:#2e9a1c'&gt;—&lt;/span&gt; скоригований контур, похибки {:g}:1</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Довідка</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрити</translation>
    </message>
    <message>
        <source>Open {}</source>
        <translation>Відкрити {}</translation>
    </message>
    <message>
        <source>Constant offset</source>
        <translation>Сталий зсув</translation>
    </message>
    <message>
        <source>What stays whatever the depth, such as a wrong tool radius; known from two depths only</source>
        <translation>Що лишається за будь-якої глибини, наприклад хибний радіус інструмента; відомо лише з двох глибин</translation>
    </message>
    <message>
        <source>MS, mean</source>
        <translation>MS, середнє</translation>
    </message>
    <message>
        <source>Share of the depth removed that the machine yields</source>
        <translation>Частка знятої глибини, на яку піддається верстат</translation>
    </message>
    <message>
        <source>MS, least</source>
        <translation>MS, найменше</translation>
    </message>
    <message>
        <source>Where the machine is stiffest</source>
        <translation>Де верстат найжорсткіший</translation>
    </message>
    <message>
        <source>MS, greatest</source>
        <translation>MS, найбільше</translation>
    </message>
    <message>
        <source>Where the machine yields most</source>
        <translation>Де верстат піддається найбільше</translation>
    </message>
    <message>
        <source>Uncertainty of MS</source>
        <translation>Невизначеність MS</translation>
    </message>
    <message>
        <source>Standard uncertainty at a point</source>
        <translation>Стандартна невизначеність у точці</translation>
    </message>
    <message>
        <source>Next depth</source>
        <translation>Наступна глибина</translation>
    </message>
    <message>
        <source>Depth that the corrected path will find</source>
        <translation>Глибина, яку зустріне скоригована траєкторія</translation>
    </message>
    <message>
        <source>Uncertainty of the correction</source>
        <translation>Невизначеність корекції</translation>
    </message>
    <message>
        <source>Standard uncertainty of where the path is put</source>
        <translation>Стандартна невизначеність положення траєкторії</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Передавальна функція</translation>
    </message>
    <message>
        <source>The machine yields in proportion to what it cuts. From the depth H of the measured part and its error δ follows the transfer function &lt;b&gt;MS = δ / (H − δ)&lt;/b&gt;; the next path commands &lt;b&gt;H · (1 + MS)&lt;/b&gt;, and removes H. That also holds at another depth, where a mirrored error does not.</source>
        <translation>Верстат піддається пропорційно до того, що знімає. З глибини H виміряної деталі та її похибки δ випливає передавальна функція &lt;b&gt;MS = δ / (H − δ)&lt;/b&gt;; наступна траєкторія задає &lt;b&gt;H · (1 + MS)&lt;/b&gt; і знімає H. Це діє й за іншої глибини, де дзеркальна похибка не діє.</translation>
    </message>
    <message>
        <source>Depths</source>
        <translation>Глибини</translation>
    </message>
    <message>
        <source>Machining system</source>
        <translation>Технологічна система</translation>
    </message>
    <message>
        <source>The first cut leaves a part of the allowance on the finished contour. Measure the part then, import the measurement, and correct with the transfer function: the second cut comes out right.</source>
        <translation>Перший прохід залишає частину припуску на готовому контурі. Потім виміряйте деталь, імпортуйте вимірювання і скоригуйте за передавальною функцією: другий прохід буде правильним.</translation>
    </message>
    <message>
        <source>A program file instead…</source>
        <translation>Натомість файл програми…</translation>
    </message>
    <message>
        <source>The first cut takes {0} {2} and leaves {1} {2}. Its path is within {3} {4} of the exact parallel.</source>
        <translation>Перший прохід знімає {0} {2} і залишає {1} {2}. Його траєкторія в межах {3} {4} від точної еквідистанти.</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Загальне</translation>
    </message>
    <message>
        <source>New corrections</source>
        <translation>Нові корекції</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Фільтр</translation>
    </message>
    <message>
        <source>What separates form from scatter: none, mean:5, mean:1,2,3,2,1, gauss:MM or auto</source>
        <translation>Що відділяє форму від розсіювання: none, mean:5, mean:1,2,3,2,1, gauss:MM або auto</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Коефіцієнт</translation>
    </message>
    <message>
        <source>Share of the deviation taken back</source>
        <translation>Частка відхилення, яка знімається</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Межа</translation>
    </message>
    <message>
        <source>Largest correction; a larger one is refused</source>
        <translation>Найбільша корекція; більша відхиляється</translation>
    </message>
    <message>
        <source>Dead band</source>
        <translation>Зона нечутливості</translation>
    </message>
    <message>
        <source>Deviations up to this are left alone</source>
        <translation>Відхилення до цієї величини не чіпаються</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Допуск</translation>
    </message>
    <message>
        <source>Largest distance of the path from the exact one</source>
        <translation>Найбільша відстань траєкторії від точної</translation>
    </message>
    <message>
        <source>New measurements</source>
        <translation>Нові вимірювання</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Точки</translation>
    </message>
    <message>
        <source>What the coordinates of a measured file are</source>
        <translation>Чим є координати файлу вимірювань</translation>
    </message>
    <message>
        <source>Ball radius</source>
        <translation>Радіус кульки</translation>
    </message>
    <message>
        <source>Radius of the probe's ball; 0: as the file says</source>
        <translation>Радіус кульки щупа; 0: як каже файл</translation>
    </message>
    <message>
        <source>Measuring programs</source>
        <translation>Вимірювальні програми</translation>
    </message>
    <message>
        <source>Control that runs measuring programs</source>
        <translation>ЧПК, на якому виконуються вимірювальні програми</translation>
    </message>
    <message>
        <source>Touch feed</source>
        <translation>Подача дотику</translation>
    </message>
    <message>
        <source>Feed of the touch</source>
        <translation>Подача дотику</translation>
    </message>
    <message>
        <source>Positioning feed</source>
        <translation>Подача позиціювання</translation>
    </message>
    <message>
        <source>Feed of moves at measuring height</source>
        <translation>Подача рухів на висоті вимірювання</translation>
    </message>
    <message>
        <source>Pictures and plots</source>
        <translation>Зображення та графіки</translation>
    </message>
    <message>
        <source>Show the deviations in the 3-D view as soon as a correction is made</source>
        <translation>Показує відхилення у тривимірному вигляді, щойно зроблено корекцію</translation>
    </message>
    <message>
        <source>Show the deviations of a new correction</source>
        <translation>Показувати відхилення нової корекції</translation>
    </message>
    <message>
        <source>Deviations and the part's size decide how much larger deviations are drawn</source>
        <translation>Відхилення й розмір деталі визначають, наскільки більшими рисуються відхилення</translation>
    </message>
    <message>
        <source>Automatic magnification</source>
        <translation>Автоматичне збільшення</translation>
    </message>
    <message>
        <source>Magnification</source>
        <translation>Збільшення</translation>
    </message>
    <message>
        <source>So many times longer than they are deviations are drawn</source>
        <translation>У стільки разів довшими рисуються відхилення</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>Верхнє відхилення</translation>
    </message>
    <message>
        <source>Larger deviations are out of tolerance: too much material is left</source>
        <translation>Більші відхилення поза допуском: залишено забагато матеріалу</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>Нижнє відхилення</translation>
    </message>
    <message>
        <source>Smaller deviations are out of tolerance: too much is cut away</source>
        <translation>Менші відхилення поза допуском: зрізано забагато</translation>
    </message>
    <message>
        <source>Material left</source>
        <translation>Залишений матеріал</translation>
    </message>
    <message>
        <source>Colour of material left; measuring machines' programs show it red</source>
        <translation>Колір залишеного матеріалу; програми вимірювальних машин показують його червоним</translation>
    </message>
    <message>
        <source>Colours of plots</source>
        <translation>Кольори графіків</translation>
    </message>
    <message>
        <source>Light or dark plots</source>
        <translation>Світлі або темні графіки</translation>
    </message>
    <message>
        <source>as the window</source>
        <translation>як вікно</translation>
    </message>
    <message>
        <source>light</source>
        <translation>світлі</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>темні</translation>
    </message>
</context>
<context>
    <name>Millcorr_Report</name>
    <message>
        <source>Directory for the report</source>
        <translation>Каталог для звіту</translation>
    </message>
    <message>
        <source>Export report…</source>
        <translation>Експортувати звіт…</translation>
    </message>
    <message>
        <source>Write the report of the selected compensated toolpath to a directory</source>
        <translation>Записує звіт вибраної скоригованої траєкторії в каталог</translation>
    </message>
    <message>
        <source>Export report</source>
        <translation>Експорт звіту</translation>
    </message>
</context>
<context>
    <name>Millcorr_Profile</name>
    <message>
        <source>Compensated profile</source>
        <translation>Скоригований профіль</translation>
    </message>
    <message>
        <source>Make the profile to cut, as a NURBS for any operation</source>
        <translation>Створює профіль для різання, як NURBS для будь-якої операції</translation>
    </message>
</context>
<context>
    <name>Millcorr_Measurement</name>
    <message>
        <source>Import measurement…</source>
        <translation>Імпортувати вимірювання…</translation>
    </message>
    <message>
        <source>Read the measured points of a part and keep the file in the document</source>
        <translation>Читає виміряні точки деталі й зберігає файл у документі</translation>
    </message>
</context>
<context>
    <name>Millcorr_Dressup</name>
    <message>
        <source>Compensated toolpath…</source>
        <translation>Скоригована траєкторія…</translation>
    </message>
    <message>
        <source>Correct the path of the selected operation from a measured part</source>
        <translation>Коригує траєкторію вибраної операції за виміряною деталлю</translation>
    </message>
</context>
<context>
    <name>Millcorr_Picture</name>
    <message>
        <source>Show deviations</source>
        <translation>Показати відхилення</translation>
    </message>
    <message>
        <source>Show or hide deviations, profiles and paths of the selected compensated toolpath</source>
        <translation>Показує або ховає відхилення, профілі й траєкторії вибраної скоригованої траєкторії</translation>
    </message>
</context>
<context>
    <name>Millcorr_Transfer</name>
    <message>
        <source>Transfer function…</source>
        <translation>Передавальна функція…</translation>
    </message>
    <message>
        <source>Correct by how far the machine yields, from the depth that was cut</source>
        <translation>Коригує за тим, наскільки піддається верстат, з глибини різання</translation>
    </message>
</context>
<context>
    <name>Millcorr_Split</name>
    <message>
        <source>Split allowance…</source>
        <translation>Поділити припуск…</translation>
    </message>
    <message>
        <source>Cut an allowance in two: measure after the first cut, correct the second</source>
        <translation>Ділить припуск на два проходи: виміряти після першого, скоригувати другий</translation>
    </message>
</context>
<context>
    <name>Millcorr_Probe</name>
    <message>
        <source>Measuring program…</source>
        <translation>Вимірювальна програма…</translation>
    </message>
    <message>
        <source>Write a program that measures the selected operation's contour on the machine</source>
        <translation>Записує програму, що вимірює контур вибраної операції на верстаті</translation>
    </message>
</context>
<context>
    <name>Millcorr_Plots</name>
    <message>
        <source>Plots</source>
        <translation>Графіки</translation>
    </message>
    <message>
        <source>Deviations along the contour and their distribution, linked to the 3-D view</source>
        <translation>Відхилення вздовж контуру та їх розподіл, зв'язані з тривимірним виглядом</translation>
    </message>
</context>
<context>
    <name>Millcorr_Simulate</name>
    <message>
        <source>Simulate…</source>
        <translation>Моделювати…</translation>
    </message>
    <message>
        <source>Run the cutter along the selected operation: force, deflection, predicted contour</source>
        <translation>Веде фрезу вздовж вибраної операції: сила, прогин, прогнозований контур</translation>
    </message>
</context>
<context>
    <name>Millcorr_Program</name>
    <message>
        <source>Correct NC program file…</source>
        <translation>Коригувати файл програми ЧПК…</translation>
    </message>
    <message>
        <source>Correct an NC program from a measured part, without any document</source>
        <translation>Коригує програму ЧПК за виміряною деталлю, без документа</translation>
    </message>
</context>
<context>
    <name>Millcorr_Batch</name>
    <message>
        <source>Batch…</source>
        <translation>Пакет…</translation>
    </message>
    <message>
        <source>Run many corrections from one file, in the background</source>
        <translation>Виконує багато корекцій з одного файлу у фоні</translation>
    </message>
</context>
<context>
    <name>Millcorr_History</name>
    <message>
        <source>History of parts…</source>
        <translation>Історія деталей…</translation>
    </message>
    <message>
        <source>Show what the journal of a series holds: parts, corrections, trends</source>
        <translation>Показує вміст журналу серії: деталі, корекції, тренди</translation>
    </message>
</context>
<context>
    <name>Millcorr_Help</name>
    <message>
        <source>Millcorr help</source>
        <translation>Довідка Millcorr</translation>
    </message>
    <message>
        <source>The documentation, page by page</source>
        <translation>Документація, сторінка за сторінкою</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Millcorr</source>
        <translation>Millcorr</translation>
    </message>
    <message>
        <source>Correct milling toolpaths from measured parts</source>
        <translation>Корекція траєкторій фрезерування за виміряними деталями</translation>
    </message>
    <message>
        <source>Macros</source>
        <translation>Макроси</translation>
    </message>
</context>
<context>
    <name>Millcorr_Macro</name>
    <message>
        <source>Correct document</source>
        <translation>Коригувати документ</translation>
    </message>
    <message>
        <source>Ask for a document and a measured file; write the corrected document, its program and the report beside it</source>
        <translation>Запитує документ і файл вимірювань; записує поруч скоригований документ, його програму і звіт</translation>
    </message>
    <message>
        <source>Correct selected operation</source>
        <translation>Коригувати вибрану операцію</translation>
    </message>
    <message>
        <source>Ask for a measured file and correct the selected operation, or the job's only Profile, with it</source>
        <translation>Запитує файл вимірювань і коригує ним вибрану операцію або єдиний Profile завдання</translation>
    </message>
    <message>
        <source>Measuring program for LinuxCNC</source>
        <translation>Вимірювальна програма для LinuxCNC</translation>
    </message>
    <message>
        <source>Ask for a file and write a measuring program of the selected operation, or of the job's only Profile</source>
        <translation>Запитує файл і записує вимірювальну програму вибраної операції або єдиного Profile завдання</translation>
    </message>
</context>
<context>
    <name>Millcorr_Said</name>
    <message>
        <source>{}: {} {} puts the path on the other side of the contour</source>
        <translation>{}: {} {} переносить траєкторію на інший бік контуру</translation>
    </message>
    <message>
        <source>{}: the operation's base geometry gives no profile; select faces or edges of it in the operation, with processPerimeter or processHoles on</source>
        <translation>{}: базова геометрія операції не дає профілю; виберіть в операції її грані або ребра, з processPerimeter чи processHoles</translation>
    </message>
    <message>
        <source>{}: lines of the pattern {} end on the pocket's walls, and would cut into them once they are corrected; choose the pattern Offset</source>
        <translation>{}: лінії шаблону {} закінчуються на стінках кишені й після корекції врізалися б у них; виберіть шаблон Offset</translation>
    </message>
    <message>
        <source>{}: the operation belongs to no job and has no base geometry</source>
        <translation>{}: операція не належить до жодного завдання і не має базової геометрії</translation>
    </message>
    <message>
        <source>{}: the job has no model</source>
        <translation>{}: завдання не має моделі</translation>
    </message>
    <message>
        <source>{}: set {} to 0, the control holds the radius (UseComp off)</source>
        <translation>{}: установіть {} на 0, радіус враховує система ЧПК (UseComp вимкнено)</translation>
    </message>
    <message>
        <source>{}: a pocket follows faces, and an edge of {} is selected</source>
        <translation>{}: кишеня йде за гранями, а вибрано ребро {}</translation>
    </message>
    <message>
        <source>{}: {}.{} is neither face nor edge</source>
        <translation>{}: {}.{} не є ні гранню, ні ребром</translation>
    </message>
    <message>
        <source>{}: {}.{} is neither level nor vertical; choose a sketch of the contour as Nominal</source>
        <translation>{}: {}.{} не горизонтальна і не вертикальна; виберіть ескіз контуру як номінальний контур</translation>
    </message>
    <message>
        <source>unknown setting {}; known are {}</source>
        <translation>невідоме налаштування {}; відомі {}</translation>
    </message>
    <message>
        <source>{}: the dressup has no operation below it</source>
        <translation>{}: під корекцією немає операції</translation>
    </message>
    <message>
        <source>{}: the operation has no path; recompute it</source>
        <translation>{}: операція не має траєкторії; перерахуйте її</translation>
    </message>
    <message>
        <source>{}: the operation cuts along no contour; check its base geometry, and that its FinalDepth lies below the edges that are selected</source>
        <translation>{}: операція не ріже вздовж жодного контуру; перевірте її базову геометрію і чи FinalDepth нижча за вибрані ребра</translation>
    </message>
    <message>
        <source>the path of {} is not the one the measured part was cut with: the difference between the two counts as an error of the machine; measure a part cut with the path as it is now</source>
        <translation>траєкторія {} не та, з якою різали виміряну деталь: різниця рахується як похибка верстата; виміряйте деталь, вирізану з теперішньою траєкторією</translation>
    </message>
    <message>
        <source>{}: the operation stands in no job</source>
        <translation>{}: операція не стоїть у жодному завданні</translation>
    </message>
    <message>
        <source>{}: a dressup lies on this operation; choose the dressup</source>
        <translation>{}: над цією операцією вже є надбудова; виберіть її</translation>
    </message>
    <message>
        <source>{}: the measurement holds no file</source>
        <translation>{}: вимірювання не містить файлу</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>немає такого файлу</translation>
    </message>
    <message>
        <source>cannot be read: {}</source>
        <translation>не читається: {}</translation>
    </message>
    <message>
        <source>{} is a measured part of {} already: switch it on instead</source>
        <translation>{} вже є виміряною деталлю {}: натомість увімкніть її</translation>
    </message>
    <message>
        <source>{}, line {}</source>
        <translation>{}, рядок {}</translation>
    </message>
    <message>
        <source>line {}</source>
        <translation>рядок {}</translation>
    </message>
    <message>
        <source>alignment: the points do not determine the {}; the fit leaves it alone</source>
        <translation>суміщення: точки не визначають {}; воно лишається як є</translation>
    </message>
    <message>
        <source>alignment: {} of {} points ({:.0f} %) lie off the rest and have no weight in the fit; is a side of the part displaced?</source>
        <translation>суміщення: {} з {} точок ({:.0f} %) лежать осторонь решти й не мають ваги; чи не зміщено якийсь бік деталі?</translation>
    </message>
    <message>
        <source>alignment: the fit hides {:.0f} % of a constant deviation such as a wrong tool or ball radius (mean {} before, {} after)</source>
        <translation>суміщення ховає {:.0f} % сталого відхилення, як від хибного радіуса інструмента чи кульки (середнє {} до, {} після)</translation>
    </message>
    <message>
        <source>alignment: the part measures {:.6f} +- {:.6f} of the profile's size ({} at {}); the scale is not applied: check temperature and unit</source>
        <translation>суміщення: деталь має {:.6f} +- {:.6f} розміру профілю ({} на {}); масштаб не застосовано: перевірте температуру й одиницю</translation>
    </message>
    <message>
        <source>{}: give none, shift, rigid, or some of x, y, turn joined by +; then :zone or :all</source>
        <translation>{}: вкажіть none, shift, rigid або щось із x, y, turn через +; далі :zone або :all</translation>
    </message>
    <message>
        <source>{}: alignment: no end after {} steps, the last one {}</source>
        <translation>{}: суміщення: немає кінця після {} кроків, останній {}</translation>
    </message>
    <message>
        <source>{}: alignment: no minimum zone after {} steps</source>
        <translation>{}: суміщення: немає мінімальної зони після {} кроків</translation>
    </message>
    <message>
        <source>{}: alignment with {} free degrees of freedom needs at least {} points, there are {}</source>
        <translation>{}: суміщення з {} ступенями вільності потребує щонайменше {} точок, є {}</translation>
    </message>
    <message>
        <source>{}: alignment: {:.0f} % of the points stay farther than {} from the profile; check unit, work frame, {} and {}</source>
        <translation>{}: суміщення: {:.0f} % точок лишаються далі ніж {} від профілю; перевірте одиницю, систему деталі, {} і {}</translation>
    </message>
    <message>
        <source>minimum zone: the linear programme failed: {}</source>
        <translation>мінімальна зона: лінійна програма не розв'язалася: {}</translation>
    </message>
    <message>
        <source>{}: alignment: the usable points do not determine the motion</source>
        <translation>{}: суміщення: придатні точки не визначають руху</translation>
    </message>
    <message>
        <source>touched along X or along Y: the slope is too near to 45 degrees to tell, and the file does not say</source>
        <translation>дотик уздовж X чи Y: нахил надто близький до 45 градусів, а файл не каже</translation>
    </message>
    <message>
        <source>touched neither along X nor along Y by the slope of the profile, and the file does not say</source>
        <translation>за нахилом профілю дотик ні вздовж X, ні вздовж Y, а файл не каже</translation>
    </message>
    <message>
        <source>the probe did not travel towards the material here</source>
        <translation>щуп тут не рухався до матеріалу</translation>
    </message>
    <message>
        <source>the points lie {:+.3f} to {} off the profile, by its slope, as if the control had shifted them along X and Y by the radius of a ball of about {}; taken back, {:.0f} of {} of scatter are left: {} with {} from the probe's calibration</source>
        <translation>точки лежать на {:+.3f} до {} від профілю, за його нахилом, ніби система ЧПК змістила їх уздовж X і Y на радіус кульки близько {}; без цього лишається {:.0f} з {} розкиду: {} з {} із калібрування щупа</translation>
    </message>
    <message>
        <source>with the shift by {} along the axis of travel taken back, {} times (1 - cos) of the slope is left, {} of scatter, {} without it</source>
        <translation>якщо зняти зміщення на {} уздовж осі руху, лишається {} разів (1 - cos) нахилу, розкид {}, без нього {}</translation>
    </message>
    <message>
        <source>{}: the points were not shifted along the axis: {}, or centre with {}</source>
        <translation>{}: точки не були зміщені вздовж осі: {}, або centre з {}</translation>
    </message>
    <message>
        <source>{}: {} seems to be about {:.2f}; see its calibration</source>
        <translation>{}: {} має бути близько {:.2f}; див. калібрування</translation>
    </message>
    <message>
        <source>{}: the probe's radius can be taken back at none of {} points, most are {}: check {}, {} and the work frame, or give each point's direction of travel</source>
        <translation>{}: радіус щупа не вдається зняти в жодній з {} точок, більшість: {}; перевірте {}, {} і систему деталі, або вкажіть напрям руху для кожної точки</translation>
    </message>
    <message>
        <source>{}: two radii of a shift need a probe that says the effective one</source>
        <translation>{}: два радіуси зміщення потребують щупа, який називає діючий</translation>
    </message>
    <message>
        <source>{}: the probe travelled along no axis, and control_radius has one radius for X and another one for Y</source>
        <translation>{}: щуп рухався не вздовж осі, а control_radius має різні радіуси для X і Y</translation>
    </message>
    <message>
        <source>farther than {} from the profile</source>
        <translation>далі ніж {} від профілю</translation>
    </message>
    <message>
        <source>beyond the end of the open profile</source>
        <translation>за кінцем незамкненого профілю</translation>
    </message>
    <message>
        <source>at a corner, where the profile has no single normal and the file gives none</source>
        <translation>у куті, де профіль не має однієї нормалі, а файл її не дає</translation>
    </message>
    <message>
        <source>two branches of the profile are equally near and the file gives no normal</source>
        <translation>дві гілки профілю однаково близькі, а файл не дає нормалі</translation>
    </message>
    <message>
        <source>in an inner corner or hollow that the cutter cannot reach</source>
        <translation>у внутрішньому куті чи западині, куди фреза не дістає</translation>
    </message>
    <message>
        <source>touched on another surface: its own normal is more than 60 degrees off the profile's there</source>
        <translation>дотик до іншої поверхні: власна нормаль відхиляється від нормалі профілю більш ніж на 60 градусів</translation>
    </message>
    <message>
        <source>{}: the program cuts the wall in steps down to {}, and the points have no height: on which of them each lies cannot be told; give the file with its third coordinate</source>
        <translation>{}: програма ріже стінку сходинками до {}, а точки не мають висоти: на якій сходинці кожна, сказати не можна; дайте файл із третьою координатою</translation>
    </message>
    <message>
        <source>{}: the probe's radius is not taken off yet: comparison.ball_radius.contact_known comes first</source>
        <translation>{}: радіус щупа ще не віднято: спершу comparison.ball_radius.contact_known</translation>
    </message>
    <message>
        <source>{}: none of the {} points can be used, most are {}; check unit, work frame, {} and {}</source>
        <translation>{}: жодна з {} точок не придатна, більшість: {}; перевірте одиницю, систему деталі, {} і {}</translation>
    </message>
    <message>
        <source>the offset path does not close near {}: check {} and {}, or give the contour with {}</source>
        <translation>зміщена траєкторія не замикається біля {}: перевірте {} і {}, або дайте контур через {}</translation>
    </message>
    <message>
        <source>the path only circles points at the tool radius {}, or turns tighter than it everywhere: there is no contour; check {} and {}</source>
        <translation>траєкторія лише обходить точки радіусом інструмента {} або всюди крутіша: контуру немає; перевірте {} і {}</translation>
    </message>
    <message>
        <source>the stretch of {} through {} was measured at that place only: {} hold all along it</source>
        <translation>ділянку {} через {} виміряно лише там: {} діє вздовж усієї</translation>
    </message>
    <message>
        <source>a correction of {} is needed at {} ({} points), more than {}; nothing was corrected: look at the place in the report of a check, and say a larger {} if it is right</source>
        <translation>потрібна корекція {} у {} ({} точок), більше ніж {}; нічого не скориговано: подивіться на місце у звіті перевірки й задайте більше {}, якщо все правильно</translation>
    </message>
    <message>
        <source>the stretch of {} near {} has no usable point</source>
        <translation>на ділянці {} біля {} немає придатної точки</translation>
    </message>
    <message>
        <source>between the points the correction swings to {} at {}, more than {}: use a stronger {}; nothing was corrected</source>
        <translation>між точками корекція розгойдується до {} у {}, більше ніж {}: потрібен сильніший {}; нічого не скориговано</translation>
    </message>
    <message>
        <source>{}: it follows its neighbours, {} to {}</source>
        <translation>{}: вона йде за сусідніми, {} до {}</translation>
    </message>
    <message>
        <source> and {} shorter gaps</source>
        <translation> і {} коротших прогалин</translation>
    </message>
    <message>
        <source>no usable point on {} between {} and {}{}: the correction runs straight across or holds its last value</source>
        <translation>немає придатної точки на {} між {} і {}{}: корекція йде навпростець або тримає останнє значення</translation>
    </message>
    <message>
        <source>{}: it is not corrected</source>
        <translation>{}: її не скориговано</translation>
    </message>
    <message>
        <source>{}: more than {} would hide what is to be corrected</source>
        <translation>{}: більше ніж {} сховало б те, що слід скоригувати</translation>
    </message>
    <message>
        <source>{} needs {}, the depth that the measured part was cut at</source>
        <translation>{} потребує {}, глибини, з якою вирізано виміряну деталь</translation>
    </message>
    <message>
        <source>a first cut that leaves stock is made before anything is measured or predicted</source>
        <translation>перший прохід, що лишає припуск, роблять до вимірювання чи прогнозу</translation>
    </message>
    <message>
        <source>{} takes the whole error out: it goes with neither {} nor {}</source>
        <translation>{} знімає всю похибку: воно не поєднується ні з {}, ні з {}</translation>
    </message>
    <message>
        <source>{} is given {} times and measured parts {}: give it once, or once for each {}</source>
        <translation>{} вказано {} разів, виміряних деталей {}: вкажіть один раз або по разу на кожне {}</translation>
    </message>
    <message>
        <source> or {}</source>
        <translation> або {}</translation>
    </message>
    <message>
        <source>{} belongs to {}, not to {}</source>
        <translation>{} належить до {}, а не до {}</translation>
    </message>
    <message>
        <source>{}: write the number or name and the diameter of a tool in mm, as {}</source>
        <translation>{}: напишіть номер чи назву й діаметр інструмента в мм, як {}</translation>
    </message>
    <message>
        <source>{} parts cut {} mm deep: the transfer function is taken from the difference, the constant offset apart; deviations are shown as at the depth of the first</source>
        <translation>{} деталі, вирізані на глибину {} мм: передавальна функція взята з різниці, сталий зсув окремо; відхилення показано як на глибині першої</translation>
    </message>
    <message>
        <source>the parts were cut at different depths: say with {} what the next one takes off</source>
        <translation>деталі різали на різну глибину: скажіть через {}, скільки знімає наступний прохід</translation>
    </message>
    <message>
        <source>{} stretches of contours without a measured point are left as they are</source>
        <translation>ділянок контурів без виміряної точки, що лишаються як є: {}</translation>
    </message>
    <message>
        <source>gain {:g} leaves {:.0f} % of what the next part would show on purpose</source>
        <translation>підсилення {:g} навмисно лишає {:.0f} % того, що показала б наступна деталь</translation>
    </message>
    <message>
        <source>one depth cannot tell a constant offset (tool radius, backlash, edge force) from elastic response: all of it is taken as elastic, which is right at the depth measured; for another depth measure two</source>
        <translation>одна глибина не відрізняє сталий зсув (радіус інструмента, люфт, сила на кромці) від піддатливості: усе вважається пружним, що правильно на виміряній глибині; для іншої виміряйте дві</translation>
    </message>
    <message>
        <source>deviations along {} with depths along the normal correct by {} more on average than {}</source>
        <translation>відхилення вздовж {} з глибинами вздовж нормалі коригують у середньому на {} більше, ніж {}</translation>
    </message>
    <message>
        <source>at {}: </source>
        <translation>у {}: </translation>
    </message>
    <message>
        <source>{}the commanded depth is {}, not above 0: a transfer function needs a cut; check {}</source>
        <translation>{}задана глибина {}, не більша за 0: передавальна функція потребує різання; перевірте {}</translation>
    </message>
    <message>
        <source>{}{} of a commanded depth of {} stayed: the transfer function delta/(H - delta) has no meaning there; check {}</source>
        <translation>{}{} із заданої глибини {} лишилося: передавальна функція delta/(H - delta) там не має сенсу; перевірте {}</translation>
    </message>
    <message>
        <source>the parts of different depth were measured at different places: nothing can be compared</source>
        <translation>деталі різної глибини виміряно в різних місцях: порівняти нічого</translation>
    </message>
    <message>
        <source>{}{:.0f} % of the difference between the depths stayed: no transfer function follows from that; check {}</source>
        <translation>{}{:.0f} % різниці глибин лишилося: передавальна функція з цього не випливає; перевірте {}</translation>
    </message>
    <message>
        <source>{}the normal is {:.0f} degrees off {}: a deviation along {} says little there; use {}</source>
        <translation>{}нормаль відхилена на {:.0f} градусів від {}: відхилення вздовж {} там мало що каже; використайте {}</translation>
    </message>
    <message>
        <source>check {} and which part was cut at which</source>
        <translation>перевірте {} і яку деталь з якою різали</translation>
    </message>
    <message>
        <source>the tool may be larger than stated or the path off; measure a part cut at another {} as well, or use {}</source>
        <translation>інструмент може бути більший, ніж сказано, або траєкторія збоку; виміряйте й деталь з іншою {}, або використайте {}</translation>
    </message>
    <message>
        <source>at {} the transfer function would be {:+.4f}, negative beyond its uncertainty of {:.4f}: no elastic system removes more than it is told to; {}</source>
        <translation>у {} передавальна функція була б {:+.4f}, від'ємна понад свою невизначеність {:.4f}: жодна пружна система не знімає більше заданого; {}</translation>
    </message>
    <message>
        <source>the transfer function would be {:.3f} in the middle: {:.0f} % of the depth would stay, which no machine is left to do; check {}</source>
        <translation>передавальна функція була б у середньому {:.3f}: лишилося б {:.0f} % глибини, чого верстат не робить; перевірте {}</translation>
    </message>
    <message>
        <source>the transfer function is {:.4f} in the middle: only {:.1f} % of the depth stays, less than milling machines give way; check {}</source>
        <translation>передавальна функція в середньому {:.4f}: лишається лише {:.1f} % глибини, менше, ніж піддаються фрезерні верстати; перевірте {}</translation>
    </message>
    <message>
        <source>the transfer function is {:.3f} at {}: {:.0f} % of the depth stays; check {}</source>
        <translation>передавальна функція {:.3f} у {}: лишається {:.0f} % глибини; перевірте {}</translation>
    </message>
    <message>
        <source>{}: choose one of {}</source>
        <translation>{}: виберіть одне з {}</translation>
    </message>
    <message>
        <source>near {} the program runs {} off the profile at {} and {} off it at {}: which pass carries the correction cannot be told; correct the first, uncorrected program, or one that holds the finishing pass alone</source>
        <translation>біля {} програма йде на {} від профілю на {} і на {} від нього на {}: який прохід несе корекцію, сказати не можна; коригуйте першу, некориговану програму або ту, що має лише чистовий прохід</translation>
    </message>
    <message>
        <source>the written program reads back with {} moves in place of {}</source>
        <translation>записана програма читається з {} рухами замість {}</translation>
    </message>
    <message>
        <source>{} stays at {}: what is wanted there is too narrow for a cutter of {}; a smaller one would reach it</source>
        <translation>{} лишається у {}: те, що там потрібне, завузьке для фрези {}; менша дістала б</translation>
    </message>
    <message>
        <source>line {} of the corrected program, which is not corrected itself, cuts {} into the corrected surface at {}, beyond what was measured: if that is a wall of the part and no lead, {} moves such passes along</source>
        <translation>рядок {} скоригованої програми, сам не скоригований, врізається на {} у скориговану поверхню у {}, за межами виміряного: якщо це стінка деталі, а не підхід, {} зсуває такі проходи разом</translation>
    </message>
    <message>
        <source>other passes on the corrected wall are moved along with it: lines {} of {}</source>
        <translation>інші проходи по скоригованій стінці зсунуто разом: рядки {} з {}</translation>
    </message>
    <message>
        <source>line {} of the written program goes to {} and not where it was planned to go</source>
        <translation>рядок {} записаної програми йде в {}, а не куди заплановано</translation>
    </message>
    <message>
        <source>the program does not cut the profile near {}, where points were measured: give the {} that cuts it, or only the points that belong to it</source>
        <translation>програма не ріже профіль біля {}, де виміряно точки: дайте {}, що його ріже, або лише точки, що до неї належать</translation>
    </message>
    <message>
        <source>no move of the program follows the profile at {}: the nearest runs {} off; check {}, {}, stock to leave and the work frame</source>
        <translation>жоден рух програми не йде за профілем на відстані {}: найближчий на {} убік; перевірте {}, {}, припуск і систему деталі</translation>
    </message>
    <message>
        <source>the compensated profile near {} cannot be fitted better than {}: the deviations change too fast; use a stronger {}</source>
        <translation>скоригований профіль біля {} не вдається наблизити краще ніж до {}: відхилення міняються зашвидко; потрібен сильніший {}</translation>
    </message>
    <message>
        <source>the correction leaves nothing of the {} long piece of the profile near {}</source>
        <translation>корекція нічого не лишає від {} ділянки профілю біля {}</translation>
    </message>
    <message>
        <source>the corrected contour does not close at the corner {}</source>
        <translation>скоригований контур не замикається в куті {}</translation>
    </message>
    <message>
        <source>the written program leaves no surface near {} that could be proven</source>
        <translation>записана програма не лишає біля {} поверхні, яку можна довести</translation>
    </message>
    <message>
        <source>line {} of the corrected program, which is not corrected itself, would cut {} into the corrected surface at {}: it leaves too little stock for it; {} moves such passes along</source>
        <translation>рядок {} скоригованої програми, сам не скоригований, врізався б на {} у скориговану поверхню у {}: він лишає замало припуску; {} зсуває такі проходи разом</translation>
    </message>
    <message>
        <source>the written program differs where it must not: line {}: {}</source>
        <translation>записана програма відрізняється там, де не повинна: рядок {}: {}</translation>
    </message>
    <message>
        <source>the written program differs where it must not: line {}: its header is another one</source>
        <translation>записана програма відрізняється там, де не повинна: рядок {}: її заголовок інший</translation>
    </message>
    <message>
        <source>the corrected {} would be {} off at {}, more than the tolerance of {}</source>
        <translation>скориговане ({}) було б на {} убік у {}, більше за допуск {}</translation>
    </message>
    <message>
        <source>path</source>
        <translation>траєкторія</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>поверхня</translation>
    </message>
    <message>
        <source>{} (the cutter gouges there)</source>
        <translation>{} (фреза там зарізає)</translation>
    </message>
    <message>
        <source>{}: where that does no harm, a larger {}</source>
        <translation>{}: де це не шкодить, більше {}</translation>
    </message>
    <message>
        <source>the posted program lacks the move to {} (command {} of the path)</source>
        <translation>у виведеній програмі бракує руху до {} (команда {} траєкторії)</translation>
    </message>
    <message>
        <source>an outlier: more probably wrong than right, by its neighbours</source>
        <translation>викид: судячи із сусідніх точок, радше хибна, ніж правильна</translation>
    </message>
    <message>
        <source>gain {:g} leaves {:.0f} % of the determined deviation on purpose</source>
        <translation>підсилення {:g} навмисно лишає {:.0f} % визначеного відхилення</translation>
    </message>
    <message>
        <source>{} of {} points cannot be used, most are {}: see the report for which</source>
        <translation>{} з {} точок не придатні, більшість: {}; які саме, див. у звіті</translation>
    </message>
    <message>
        <source>a tool's diameter {} for {}</source>
        <translation>діаметр інструмента {} замість {}</translation>
    </message>
    <message>
        <source>mean {} all along, form only {}: check for {}; else the machine gives way</source>
        <translation>середнє {} всюди, форма лише {}: перевірте, чи це {}; інакше піддається верстат</translation>
    </message>
    <message>
        <source>sides that lie {} off the other {} all along (each within {}): {}, the first at {}; compare that dimension with the drawing: another revision, or a wall that gives way</source>
        <translation>сторони, що всюди на {} від інших {} (кожна в межах {}): {}, перша у {}; порівняйте цей розмір із кресленням: інша редакція або піддатлива стінка</translation>
    </message>
    <message>
        <source>only {} of {} points can be used, most others are {}: is the program whole, and is it the one that cut the part?</source>
        <translation>лише {} з {} точок придатні, більшість інших: {}; чи програма ціла і чи саме вона різала деталь?</translation>
    </message>
    <message>
        <source>check the height of the work frame of the measurement</source>
        <translation>перевірте висоту системи деталі у вимірюванні</translation>
    </message>
    <message>
        <source>{} of {} points on the profile ({} to {}) lie {} all that the program cuts, {}: {}, or leave the column z out</source>
        <translation>{} з {} точок на профілі ({} до {}) лежать {} всього, що ріже програма, {}: {}, або не беріть стовпець z</translation>
    </message>
    <message>
        <source>{} points (from {}) lie below the deepest pass at {}: {}</source>
        <translation>{} точок (від {}) лежать нижче найглибшого проходу на {}: {}</translation>
    </message>
    <message>
        <source>{} points (up to {}) lie above {}, from where the cutter comes down: {}</source>
        <translation>{} точок (до {}) лежать вище {}, звідки опускається фреза: {}</translation>
    </message>
    <message>
        <source>a probe's radius {} for {}</source>
        <translation>радіус щупа {} замість {}</translation>
    </message>
    <message>
        <source>steel measured {:.0f} K too warm</source>
        <translation>сталь виміряно на {:.0f} K теплішою</translation>
    </message>
    <message>
        <source>{:.0f} % of the deviations are what a shift of X{} Y{} and a turn of {:+.0f} arc seconds would give: check the alignment of the measurement ({}), or correct the work offset</source>
        <translation>{:.0f} % відхилень такі, які дав би зсув X{} Y{} і поворот на {:+.0f} кутових секунд: перевірте вирівнювання вимірювання ({}) або виправте зсув нуля</translation>
    </message>
    <message>
        <source>{:.0f} % of the deviations are what a size of {:.6f} times the profile's would give ({} at the rim; steel grows by 11.5 millionths a degree): check temperature, unit and scale of the measurement; no scale is ever applied</source>
        <translation>{:.0f} % відхилень такі, які дав би розмір у {:.6f} раза від профілю ({} на краю; сталь росте на 11,5 мільйонних на градус): перевірте температуру, одиницю й масштаб вимірювання; масштаб ніколи не застосовується</translation>
    </message>
    <message>
        <source>{} to {}</source>
        <translation>{} до {}</translation>
    </message>
    <message>
        <source>{} up</source>
        <translation>{} і вище</translation>
    </message>
    <message>
        <source>below</source>
        <translation>нижче</translation>
    </message>
    <message>
        <source>above</source>
        <translation>вище</translation>
    </message>
    <message>
        <source>a probe's radius {} too small</source>
        <translation>радіус щупа на {} замалий</translation>
    </message>
    <message>
        <source>a probe's radius {} too large</source>
        <translation>радіус щупа на {} завеликий</translation>
    </message>
    <message>
        <source>{} of stock left</source>
        <translation>{} лишеного припуску</translation>
    </message>
    <message>
        <source>times 25.4</source>
        <translation>помножені на 25,4</translation>
    </message>
    <message>
        <source>divided by 25.4</source>
        <translation>поділені на 25,4</translation>
    </message>
    <message>
        <source>with z reversed</source>
        <translation>з оберненим z</translation>
    </message>
    <message>
        <source>{} they would lie there; check the unit of z and the height of the work frame</source>
        <translation>{} вони лежали б там; перевірте одиницю z і висоту системи деталі</translation>
    </message>
    <message>
        <source>steel measured {:.0f} K too cold</source>
        <translation>сталь виміряно на {:.0f} K холоднішою</translation>
    </message>
    <message>
        <source>{}: the nominal was probably exported in place of the measured points; export the actual points, to 0.0001 mm</source>
        <translation>{}: мабуть, замість виміряних точок виведено номінал; виведіть фактичні точки, до 0,0001 мм</translation>
    </message>
    <message>
        <source>{} states a deviation of {}, its points give {} ({} of {} disagree): {}; leave the column of deviations out, or correct it</source>
        <translation>{} подає відхилення {}, а його точки дають {} ({} з {} не збігаються): {}; не беріть стовпець відхилень або виправте його</translation>
    </message>
    <message>
        <source>the {} points are a height map, touched along Z: they show nothing of a contour; touch its walls with a measuring program</source>
        <translation>{} точок є картою висот, дотики вздовж Z: вони нічого не показують про контур; торкніться його стінок вимірювальною програмою</translation>
    </message>
    <message>
        <source>a ball of radius {} is on no touch probe ({} to {})</source>
        <translation>кульки радіуса {} немає на жодному щупі ({} до {})</translation>
    </message>
    <message>
        <source>the points extend over {}, and the file does not say its unit: {}? Say {} if it is right, {}, or export in mm</source>
        <translation>точки простягаються на {}, а файл не називає одиниці: {}? Скажіть {}, якщо так і є, {}, або виведіть у мм</translation>
    </message>
    <message>
        <source>the coordinates are given in steps of {}, which alone scatters deviations by {} (standard deviation): export to 0.0001 mm</source>
        <translation>координати подано з кроком {}, що саме розкидає відхилення на {} (стандартне відхилення): виведіть до 0,0001 мм</translation>
    </message>
    <message>
        <source>every deviation is 0</source>
        <translation>кожне відхилення дорівнює 0</translation>
    </message>
    <message>
        <source>no deviation is larger than {}, what rounding to {} alone makes</source>
        <translation>жодне відхилення не більше за {}, що дає саме округлення до {}</translation>
    </message>
    <message>
        <source>its sign is the other way round, positive into the material</source>
        <translation>його знак обернений, додатний углиб матеріалу</translation>
    </message>
    <message>
        <source>check what its columns mean</source>
        <translation>перевірте, що означають його стовпці</translation>
    </message>
    <message>
        <source>{}; {:.4g} inch are {}, and the file does not say its unit: {}</source>
        <translation>{}; {:.4g} дюйма це {}, а файл не називає одиниці: {}</translation>
    </message>
    <message>
        <source>{}: {} takes a radius in mm</source>
        <translation>{}: {} є радіусом у мм</translation>
    </message>
    <message>
        <source>metres or inches</source>
        <translation>метри чи дюйми</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>мікрометри</translation>
    </message>
    <message>
        <source>{}: there is no such finding; known are {}</source>
        <translation>{}: такої знахідки немає; відомі {}</translation>
    </message>
    <message>
        <source>accepted {}: {}</source>
        <translation>прийнято {}: {}</translation>
    </message>
    <message>
        <source>the part shows {:.0f} % of just the errors (up to {}) that the program takes away already, {:.0f} % of its deviations: was it cut with this program, and not with the earlier one? Measure a part cut with this program, or give the program that cut this one</source>
        <translation>деталь показує {:.0f} % саме тих похибок (до {}), які програма вже знімає, {:.0f} % її відхилень: чи різано її цією програмою, а не попередньою? Виміряйте деталь, вирізану цією програмою, або дайте програму, що різала цю</translation>
    </message>
    <message>
        <source>{:.0f} % of the points of {} lie where {} has none, and only places of the first part tell the transfer function: name first the part that was measured all round ({})</source>
        <translation>{:.0f} % точок {} лежать там, де {} їх не має, а передавальну функцію дають лише місця першої деталі: назвіть першою деталь, виміряну довкола ({})</translation>
    </message>
    <message>
        <source>{:.0f} % of the points of {} lie within {} of those of {}: the same part again, and no mean of two; give each part once</source>
        <translation>{:.0f} % точок {} лежать у межах {} від точок {}: знову та сама деталь, а не середнє двох; дайте кожну деталь один раз</translation>
    </message>
    <message>
        <source>the file's own nominal points lie {} off the profile: check {}, the operation and the work frame</source>
        <translation>власні номінальні точки файлу лежать на {} від профілю: перевірте {}, операцію і систему деталі</translation>
    </message>
    <message>
        <source>the normals of {} of {} points point into the material: export normals out of the material, not directions of approach</source>
        <translation>нормалі {} з {} точок дивляться в матеріал: виведіть нормалі з матеріалу назовні, а не напрями підходу</translation>
    </message>
    <message>
        <source>points on thin walls that lie so far off that the other side may be meant: {}, the thinnest wall {} ({}, {}); the file has no normals: export normals</source>
        <translation>точки на тонких стінках, що лежать так далеко, що може йтися про інший бік: {}, найтонша стінка {} ({}, {}); файл не має нормалей: виведіть нормалі</translation>
    </message>
    <message>
        <source>mirror the work frame of the measurement</source>
        <translation>віддзеркальте систему деталі у вимірюванні</translation>
    </message>
    <message>
        <source>turn the work frame of the measurement back</source>
        <translation>поверніть систему деталі у вимірюванні назад</translation>
    </message>
    <message>
        <source>the points lie {} off {} all along, with only {} of scatter</source>
        <translation>точки всюди лежать на {} від {}, з розкидом лише {}</translation>
    </message>
    <message>
        <source>the surface {} over the profile</source>
        <translation>поверхні на {} над профілем</translation>
    </message>
    <message>
        <source>the profile</source>
        <translation>профілю</translation>
    </message>
    <message>
        <source>{}: {} seems to be the diameter: {}</source>
        <translation>{}: {} схоже на діаметр: {}</translation>
    </message>
    <message>
        <source>{}: {} seems to be half of what it should be: {}</source>
        <translation>{}: {} схоже на половину потрібного: {}</translation>
    </message>
    <message>
        <source>{}, the cutter's diameter: the profile was taken on the wrong side of the path: {}</source>
        <translation>{}, діаметр фрези: профіль узято з хибного боку траєкторії: {}</translation>
    </message>
    <message>
        <source>{}: what a transfer function of {:.3f} leaves of {}</source>
        <translation>{}: те, що передавальна функція {:.3f} лишає від {}</translation>
    </message>
    <message>
        <source>{}: check {}, by this {} were left, and {} and {}</source>
        <translation>{}: перевірте {}, за ним лишилося б {}, і {} та {}</translation>
    </message>
    <message>
        <source>{}: they look like centres of a ball of about that radius: {} with the radius from the probe's calibration; or stock was left there ({}), or the tool differs from {}</source>
        <translation>{}: вони схожі на центри кульки приблизно такого радіуса: {} з радіусом із калібрування щупа; або там лишено припуск ({}), або інструмент відрізняється від {}</translation>
    </message>
    <message>
        <source>{}: check {}, {} (stock left on the part), {} and the work frame</source>
        <translation>{}: перевірте {}, {} (припуск, лишений на деталі), {} і систему деталі</translation>
    </message>
    <message>
        <source>{}: check {}, {} and the work frame</source>
        <translation>{}: перевірте {}, {} і систему деталі</translation>
    </message>
    <message>
        <source>times {:g}</source>
        <translation>помножені на {:g}</translation>
    </message>
    <message>
        <source>the file is in inches: {}</source>
        <translation>файл у дюймах: {}</translation>
    </message>
    <message>
        <source>divided by {:g}</source>
        <translation>поділені на {:g}</translation>
    </message>
    <message>
        <source>the file is in millimetres or was converted twice: {}</source>
        <translation>файл у міліметрах або переведений двічі: {}</translation>
    </message>
    <message>
        <source>with x reversed</source>
        <translation>з оберненим x</translation>
    </message>
    <message>
        <source>with y reversed</source>
        <translation>з оберненим y</translation>
    </message>
    <message>
        <source>with x and y exchanged</source>
        <translation>з переставленими x та y</translation>
    </message>
    <message>
        <source>exchange the columns x and y</source>
        <translation>переставте стовпці x та y</translation>
    </message>
    <message>
        <source>with x and y exchanged and reversed</source>
        <translation>з переставленими й оберненими x та y</translation>
    </message>
    <message>
        <source>turned by {} degrees</source>
        <translation>повернуті на {} градусів</translation>
    </message>
    <message>
        <source>{:.0f} % of the points lie on the profile, but {} {:.0f} %</source>
        <translation>{:.0f} % точок лежать на профілі, але {} {:.0f} %</translation>
    </message>
    <message>
        <source>{}: they are contact points already: {}</source>
        <translation>{}: це вже точки дотику: {}</translation>
    </message>
    <message>
        <source>{}; check {} if that seems much</source>
        <translation>{}; перевірте {}, якщо це забагато</translation>
    </message>
    <message>
        <source>the points lie typically {} off the profile, but {} {}</source>
        <translation>точки лежать типово на {} від профілю, але {} {}</translation>
    </message>
    <message>
        <source>{:.0f} % of the contour has no measured point near, most of it between {} and {}: measure there, or say with {} how much may be left to the mean</source>
        <translation>{:.0f} % контуру не має виміряної точки поблизу, найбільше між {} і {}: виміряйте там або скажіть через {}, скільки можна лишити середньому</translation>
    </message>
    <message>
        <source>{} of {} points are outliers: clean the part and the probe, measure again</source>
        <translation>{} з {} точок є викидами: почистьте деталь і щуп та виміряйте знову</translation>
    </message>
    <message>
        <source>the wall leans: at {} it has {} more than at {} {}; one path corrects the mean of the heights: a spring pass or less overhang of the tool takes the lean away</source>
        <translation>стінка нахилена: на {} вона має на {} більше, ніж на {} {}; одна траєкторія коригує середнє висот: зачисний прохід або менший виліт інструмента знімає нахил</translation>
    </message>
    <message>
        <source>{} of {} points are outliers, the first at {}: clean the part and the probe, measure again</source>
        <translation>{} з {} точок є викидами, перша у {}: почистьте деталь і щуп та виміряйте знову</translation>
    </message>
    <message>
        <source>all along</source>
        <translation>всюди</translation>
    </message>
    <message>
        <source>at {}, {} on the average</source>
        <translation>у {}, {} у середньому</translation>
    </message>
    <message>
        <source>{} touches, {} of {} ways between them over the safe height</source>
        <translation>{} дотиків, {} з {} переходів між ними через безпечну висоту</translation>
    </message>
    <message>
        <source>measured at {}, passed over at {}</source>
        <translation>вимірюється на {}, перехід на {}</translation>
    </message>
    <message>
        <source>points</source>
        <translation>точки</translation>
    </message>
    <message>
        <source>heights</source>
        <translation>висоти</translation>
    </message>
    <message>
        <source>{} and {} more</source>
        <translation>{} та ще {}</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>застереження</translation>
    </message>
    <message>
        <source>log</source>
        <translation>протокол</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>вилучено</translation>
    </message>
    <message>
        <source>on the profile</source>
        <translation>на профілі</translation>
    </message>
    <message>
        <source>deviation {} ({})</source>
        <translation>відхилення {} ({})</translation>
    </message>
    <message>
        <source>of that determined {}, expected next {}</source>
        <translation>з того визначено {}, далі очікується {}</translation>
    </message>
    <message>
        <source>left out: {}</source>
        <translation>вилучено: {}</translation>
    </message>
    <message>
        <source>{} as measured</source>
        <translation>{} як виміряно</translation>
    </message>
    <message>
        <source>material left</source>
        <translation>залишок матеріалу</translation>
    </message>
    <message>
        <source>undercut</source>
        <translation>підріз</translation>
    </message>
    <message>
        <source>nothing is to be corrected, the program stays as it is</source>
        <translation>коригувати нічого, програма лишається як є</translation>
    </message>
    <message>
        <source>{}; {:.0f} % of the contour rests on no points</source>
        <translation>{}; {:.0f} % контуру не спирається на точки</translation>
    </message>
    <message>
        <source>use it</source>
        <translation>Застосувати</translation>
    </message>
    <message>
        <source>look at {}</source>
        <translation>Подивитися: {}</translation>
    </message>
    <message>
        <source>{} of {} points are outliers, there the largest</source>
        <translation>{} з {} точок є викидами, там найбільший</translation>
    </message>
    <message>
        <source>only the path's own error changes</source>
        <translation>змінюється лише власна похибка траєкторії</translation>
    </message>
    <message>
        <source>the contour moves by up to {}, most at {}</source>
        <translation>контур зсувається до {}, найбільше у {}</translation>
    </message>
    <message>
        <source>use it, and measure the first part</source>
        <translation>Застосувати й виміряти першу деталь</translation>
    </message>
    <message>
        <source>{}, by the model alone</source>
        <translation>{}, лише за моделлю</translation>
    </message>
    <message>
        <source>use it if what the warnings ask is answered</source>
        <translation>Застосувати, якщо з'ясовано те, про що питають застереження</translation>
    </message>
    <message>
        <source>{} was accepted and is not resolved</source>
        <translation>{} прийнято й не усунуто</translation>
    </message>
    <message>
        <source>measure again or average parts</source>
        <translation>Виміряти знову або усереднити деталі</translation>
    </message>
    <message>
        <source>{} do not repeat, only {} do</source>
        <translation>{} не повторюється, лише {} повторюється</translation>
    </message>
    <message>
        <source>legal filters: none, mean:5, mean:1,2,3,2,1 (odd number of weights), gauss:MM, robust:MM, auto</source>
        <translation>дозволені фільтри: none, mean:5, mean:1,2,3,2,1 (непарна кількість ваг), gauss:MM, robust:MM, auto</translation>
    </message>
    <message>
        <source>a single point: its deviation is taken as it is, the random part cannot be known</source>
        <translation>одна точка: її відхилення береться як є, випадкову частину не визначити</translation>
    </message>
    <message>
        <source>arc lengths and deviations must be equally long rows, not {}, {}</source>
        <translation>довжини дуг і відхилення мають бути рядами однакової довжини, а не {}, {}</translation>
    </message>
    <message>
        <source>there are no deviations to filter</source>
        <translation>немає відхилень для фільтрування</translation>
    </message>
    <message>
        <source>an arc length or a deviation is not a finite number</source>
        <translation>довжина дуги чи відхилення не є скінченним числом</translation>
    </message>
    <message>
        <source>the length of the stretch must be above 0, not {:g}</source>
        <translation>довжина ділянки має бути більша за 0, а не {:g}</translation>
    </message>
    <message>
        <source>the mask of {} is longer than the row of {} points: cut to {}</source>
        <translation>маска з {} довша за ряд із {} точок: скорочено до {}</translation>
    </message>
    <message>
        <source>the mask is not symmetric: it shifts the deviations along the profile</source>
        <translation>маска не симетрична: вона зсуває відхилення вздовж профілю</translation>
    </message>
    <message>
        <source>the points are unevenly spaced (up to {}, median {}) and the moving average counts points: prefer gauss:MM or auto</source>
        <translation>точки розміщені нерівномірно (до {}, медіана {}), а ковзне середнє рахує точки: краще gauss:MM або auto</translation>
    </message>
    <message>
        <source>the mask sums to 0 at an end of the row: those points are left unfiltered</source>
        <translation>сума маски на кінці ряду 0: ці точки лишаються нефільтрованими</translation>
    </message>
    <message>
        <source>the cutoff of {} is below twice the point spacing ({}): next to nothing is filtered</source>
        <translation>гранична довжина хвилі {} менша за подвійний крок точок ({}): майже нічого не фільтрується</translation>
    </message>
    <message>
        <source>the robust regression did not settle within {} rounds</source>
        <translation>робастна регресія не усталилася за {} проходів</translation>
    </message>
    <message>
        <source>points far off the line, which are outliers and left out: {}</source>
        <translation>точки далеко від лінії, які є викидами й не враховані: {}</translation>
    </message>
    <message>
        <source>unknown filter '{}'; {}</source>
        <translation>невідомий фільтр «{}»; {}</translation>
    </message>
    <message>
        <source>filter '{}' holds a number that is not finite; {}</source>
        <translation>фільтр «{}» містить число, що не є скінченним; {}</translation>
    </message>
    <message>
        <source>filter '{}' has an even number of weights; {}</source>
        <translation>фільтр «{}» має парну кількість ваг; {}</translation>
    </message>
    <message>
        <source>the weights of filter '{}' add up to 0; {}</source>
        <translation>ваги фільтра «{}» дають у сумі 0; {}</translation>
    </message>
    <message>
        <source>the points spread over {} of a stretch of {}</source>
        <translation>точки простягаються на {} ділянки {}</translation>
    </message>
    <message>
        <source>the mask of {} is longer than the row of {} points</source>
        <translation>маска з {} довша за ряд із {} точок</translation>
    </message>
    <message>
        <source>filter '{}' holds something that is not a number; {}</source>
        <translation>фільтр «{}» містить щось, що не є числом; {}</translation>
    </message>
    <message>
        <source>filter '{}' needs one cutoff in mm above 0; {}</source>
        <translation>фільтр «{}» потребує граничної довжини хвилі в мм, більшої за 0; {}</translation>
    </message>
    <message>
        <source>filter '{}' needs an odd whole number of points; {}</source>
        <translation>фільтр «{}» потребує непарного цілого числа точок; {}</translation>
    </message>
    <message>
        <source>part {} was measured at other places than the first: nothing can be averaged</source>
        <translation>деталь {} виміряно в інших місцях, ніж першу: усереднити нічого</translation>
    </message>
    <message>
        <source>{}: the points lie {} off the profile and not {} over it: check {}; it belongs to a part with stock left on it, and {} is then the program that finishes it</source>
        <translation>{}: точки лежать на {} від профілю, а не на {} над ним: перевірте {}; воно належить до деталі з лишеним припуском, і тоді {} є програмою, що її закінчує</translation>
    </message>
    <message>
        <source>the diameter of {} is not known</source>
        <translation>діаметр {} невідомий</translation>
    </message>
    <message>
        <source>what is cut under {} is another part than the measured one, cut under {}: it stays as it is</source>
        <translation>те, що ріжеться під {}, є іншою деталлю, ніж виміряна, різана під {}: воно лишається як є</translation>
    </message>
    <message>
        <source>the tool diameter {} must be a length above 0</source>
        <translation>діаметр інструмента {} має бути довжиною більшою за 0</translation>
    </message>
    <message>
        <source>the same measurement is given twice: averaging needs different parts</source>
        <translation>те саме вимірювання дано двічі: усереднення потребує різних деталей</translation>
    </message>
    <message>
        <source>{} carries the correction from this measurement already, since {}: the part was cut by an earlier program, so all is shown as if this one carried no correction</source>
        <translation>{} вже несе корекцію з цього вимірювання, від {}: деталь вирізано попередньою програмою, тож усе показано так, ніби ця не несе корекції</translation>
    </message>
    <message>
        <source>{}:{}: a part with stock left was cut by a first cut of the uncorrected program: give that as {}, not one that was corrected since</source>
        <translation>{}:{}: деталь із лишеним припуском вирізано першим проходом некоригованої програми: дайте її як {}, а не скориговану відтоді</translation>
    </message>
    <message>
        <source>{} needs {}: one touch or two; without any {}</source>
        <translation>{} потребує {}: одного чи двох дотиків; без них {}</translation>
    </message>
    <message>
        <source>{} takes no {}: with touches use {}</source>
        <translation>{} не приймає {}: з дотиками використайте {}</translation>
    </message>
    <message>
        <source>a first cut that leaves stock is made before anything is measured</source>
        <translation>перший прохід, що лишає припуск, роблять до вимірювання</translation>
    </message>
    <message>
        <source>{}: no move runs along the contour that the points lie on</source>
        <translation>{}: жоден рух не йде вздовж контуру, на якому лежать точки</translation>
    </message>
    <message>
        <source>{}:{}: {} names a corrected program; give the first, uncorrected one</source>
        <translation>{}:{}: {} називає скориговану програму; дайте першу, некориговану</translation>
    </message>
    <message>
        <source>{} or {}: the program has no G41 or G42 that tells the side of the cutter</source>
        <translation>{} або {}: програма не має G41 чи G42, що назвали б бік фрези</translation>
    </message>
    <message>
        <source>{} states it</source>
        <translation>{} називає його</translation>
    </message>
    <message>
        <source>a T word before its cuts gives it a number to state</source>
        <translation>слово T перед його різами дає йому номер, щоб назвати</translation>
    </message>
    <message>
        <source>{}: what it cuts stays as it is and is not looked at; {}</source>
        <translation>{}: що він ріже, лишається як є й не розглядається; {}</translation>
    </message>
    <message>
        <source>{}: the program has no feed move that could follow a contour</source>
        <translation>{}: програма не має робочого руху, що міг би йти за контуром</translation>
    </message>
    <message>
        <source>nothing that runs along a contour is read: {}; write the moves in place of this line, as {}</source>
        <translation>нічого, що йде вздовж контуру, не читається: {}; напишіть рухи замість цього рядка, як {}</translation>
    </message>
    <message>
        <source>{}: a cutter of {} takes no more than its width off; the depth is meant along the contour's normal, from the stock to the surface, in mm</source>
        <translation>{}: фреза {} знімає не більше за свою ширину; глибина розуміється вздовж нормалі контуру, від заготовки до поверхні, у мм</translation>
    </message>
</context>
</TS>
